// Holds the final gather of a captured scene against dense rays into its radiosity solution, at visible points all over
// the picture. Prints what it finds as JSON.
//
// usage: capture_oracle CAPTURE POINTS RAYS
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <vector>

#include "oracles/solution_irradiance.h"
#include "render/capture.h"
#include "support/grid_picture.h"
#include "trace/surface_point.h"

namespace gg::test {
namespace {

void compare(const char* path, std::size_t points, std::uint32_t rays) {
    const Capture capture = read_capture(path);
    PictureSettings settings;
    settings.width = capture.settings.width;
    settings.height = capture.settings.height;
    settings.cell = capture.settings.gather.cell * static_cast<float>(std::min(settings.width, settings.height)) / 350;
    settings.threshold = capture.settings.gather.threshold;
    settings.samples = capture.settings.gather.samples;
    const GridPicture picture(capture.scene, capture.settings.camera, settings);
    std::vector<PlacedFragment> placed;
    for (Fragment at : picture.some_fragments(points)) {
        at.shading_normal = at.normal;  // the oracle knows no other
        at.share = 1;
        placed.push_back(picture.place(at));
    }
    Shader shader = picture.shader();
    const std::vector<Rgb> light = light_at(shader, placed);
    std::vector<double> errors;
    double ours = 0, truth = 0, squares = 0;
    for (std::size_t i = 0; i < placed.size(); ++i) {
        const Fragment& at = placed[i].at;
        const Vec3 x = offset_origin(at.position, at.normal, 1);
        const double exact = static_cast<double>(luminance(
            Rgb(oracle::solution_irradiance(*picture.solution, *picture.prepared.tracer, x, at.normal, rays))));
        const double own = static_cast<double>(luminance(light[i]));
        ours += own;
        truth += exact;
        squares += std::pow(own - exact, 2);
        errors.push_back(std::abs(own / std::max(exact, 1e-12) - 1));
    }
    std::sort(errors.begin(), errors.end());
    const auto count = static_cast<double>(errors.size());
    std::printf("{\"points\": %zu, \"mean_ratio\": %.5f, \"rel_rmse\": %.5f, \"median_error\": %.5f}\n", errors.size(),
                ours / truth, std::sqrt(squares / count) / (truth / count), errors[errors.size() / 2]);
}

}  // namespace
}  // namespace gg::test

int main(int count, char** arguments) {
    if (count != 4) {
        std::fprintf(stderr, "usage: capture_oracle CAPTURE POINTS RAYS\n");
        return 2;
    }
    try {
        gg::test::compare(arguments[1], std::strtoul(arguments[2], nullptr, 10),
                          static_cast<std::uint32_t>(std::strtoul(arguments[3], nullptr, 10)));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
