// Error of element and cluster radiosities over quality, on small scenes, against random walks: a table for each scene.
//
//   radiosity_error [WALKS]      walks for every leaf that is looked at, 8000
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "core/parallel.h"
#include "core/random.h"
#include "oracles/path_irradiance.h"
#include "support/clouds.h"
#include "support/law_scenes.h"
#include "support/solution_measures.h"

namespace gg::test {
namespace {

constexpr std::size_t kLeaves = 400;

// A room with a thousand leaves before its window, lit by a lamp behind them, and a cupboard with two shelves.
SceneDescription foliage_and_shelves() {
    SceneBuilder builder;
    const auto wall = builder.material(Rgb(0.7F)), leaf = builder.material(Rgb(0.3F)),
               wood = builder.material(Rgb(0.4F));
    builder.box(Vec3(0.0F), kRoomSize, {wall, wall, wall, wall, wall, wall}, true);
    builder.area_light({0.1F, 1.5F, 1.4F}, {1, 0, 0}, 1, Rgb(100), "window");
    Box plant;
    plant.extend(Vec3(0.3F, 1.0F, 0.8F));
    plant.extend(Vec3(0.9F, 2.0F, 1.9F));
    builder.add_mesh(triangle_cloud(plant, 1000, 0.06F, 7), leaf);
    for (const float height : {0.5F, 1.0F, 1.5F}) {
        builder.solid({3.4F, 0.5F, height}, {3.99F, 2.5F, height + 0.03F}, wood, "shelf");
    }
    return builder.description;
}

struct Errors {
    double mean_ratio = 0, rms = 0;  // of all irradiance; root of the mean square over the mean, both by area
};

Errors errors_of(const Prepared& prepared, const Solution& solution, std::uint32_t walks) {
    const std::vector<NodeId> leaves = surface_leaves(solution);
    const std::size_t stride = std::max<std::size_t>(1, leaves.size() / kLeaves);
    const std::size_t count = (leaves.size() + stride - 1) / stride;
    std::vector<double> ours(count), truth(count), area(count);
    const oracle::WalkedScene walked{prepared.scene, *prepared.colors, *prepared.tracer};
    parallel_for(count, 1, prepared.control, [&](std::size_t i) {
        const NodeId id = leaves[i * stride];
        const Node& node = solution.hierarchy[id];
        ours[i] = luminance(solution.lighting.irradiance(id));
        truth[i] = luminance_of(oracle::mean_irradiance(walked, solution.hierarchy, node, walks));
        area[i] = node.area;
    });
    double whole = 0, sum_ours = 0, sum_truth = 0, squares = 0;
    for (std::size_t i = 0; i < count; ++i) {
        whole += area[i];
        sum_ours += area[i] * ours[i];
        sum_truth += area[i] * truth[i];
        squares += area[i] * (ours[i] - truth[i]) * (ours[i] - truth[i]);
    }
    return {sum_ours / sum_truth, std::sqrt(squares / whole) / (sum_truth / whole)};
}

void report(const char* name, const SceneDescription& description, std::uint32_t walks) {
    std::printf("%s\n%8s %8s %8s %10s %8s\n", name, "quality", "leaves", "seconds", "mean ratio", "rms");
    for (const float quality : {0.16F, 0.08F, 0.04F, 0.02F, 0.01F, 0.005F}) {
        Prepared prepared(description);
        const auto begin = std::chrono::steady_clock::now();
        const auto solution = prepared.solve(quality);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
        const Errors errors = errors_of(prepared, *solution, walks);
        std::printf("%8.3f %8zu %8.3f %10.3f %8.3f\n", static_cast<double>(quality), surface_leaves(*solution).size(),
                    seconds.count(), errors.mean_ratio, errors.rms);
        std::fflush(stdout);
    }
}

}  // namespace
}  // namespace gg::test

int main(int count, char** arguments) {
    const int walks = count > 1 ? std::atoi(arguments[1]) : 8000;
    if (walks <= 0) {
        std::fprintf(stderr, "radiosity_error [WALKS]: WALKS must be a number above 0\n");
        return 2;
    }
    const auto n = static_cast<std::uint32_t>(walks);
    gg::test::report("lamp and furniture", gg::test::lamp_room(0.7F), n);
    gg::test::report("foliage and shelves", gg::test::foliage_and_shelves(), n);
    gg::test::report("sun, sky, lamps, clouds", gg::test::mixed_scene(), n);
    return 0;
}
