#include "api/convert_settings.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <thread>

#include "api/convert_scene.h"
#include "api/guard.h"

namespace gg {

namespace {

constexpr std::uint32_t kLargestPicture = 65536;

// The camera's axes at unit length and right angles, mirrored where they were: scale has no meaning for a camera.
Affine without_scale(const Affine& placed) {
    const Vec3 back = normalize_or_zero(placed.linear[2]);
    const Vec3 up = normalize_or_zero(placed.linear[1] - dot(placed.linear[1], back) * back);
    const Vec3 side = placed.linear[0] - dot(placed.linear[0], back) * back;
    const Vec3 right = normalize_or_zero(side - dot(side, up) * up);
    require(back != Vec3(0) && up != Vec3(0) && right != Vec3(0), "the camera's matrix is singular");
    return {Mat3(right, up, back), placed.translation};
}

CameraDescription convert_camera(const gg_camera& camera) {
    const auto finite = [](float value) { return std::isfinite(value); };
    require(camera.type == GG_CAMERA_PERSPECTIVE || camera.type == GG_CAMERA_ORTHOGRAPHIC, "unknown camera type");
    require(std::all_of(camera.matrix, camera.matrix + 12, finite), "the camera's matrix is not finite");
    require(std::all_of(camera.window, camera.window + 4, finite) && camera.window[0] < camera.window[1] &&
                camera.window[2] < camera.window[3],
            "the camera's window is empty or not finite");
    require(camera.clip_start >= 0 && camera.clip_start < camera.clip_end, "the camera's clip range is empty");
    CameraDescription result;
    result.type = static_cast<CameraType>(camera.type);
    result.to_world = without_scale(convert_matrix(camera.matrix));
    std::copy_n(camera.window, 4, result.window);
    result.clip_start = camera.clip_start;
    result.clip_end = camera.clip_end;
    return result;
}

Rectangle convert_crop(const gg_settings& settings) {
    const std::uint32_t(&crop)[4] = settings.crop;
    if (std::all_of(crop, crop + 4, [](std::uint32_t value) { return value == 0; })) {
        return {0, 0, settings.width, settings.height};
    }
    require(crop[2] >= 1 && crop[3] >= 1 && crop[0] < settings.width && crop[1] < settings.height &&
                crop[2] <= settings.width - crop[0] && crop[3] <= settings.height - crop[1],
            "the crop does not lie within the picture");
    return {crop[0], crop[1], crop[2], crop[3]};
}

// `value`, or `standard` where it is 0.
float number(float value, float standard, float least, float most, const char* what) {
    if (value == 0) {
        return standard;
    }
    require(value >= least && value <= most, what);
    return value;
}

Viewing convert_viewing(const gg_display& display) {
    Viewing viewing;
    viewing.white = number(display.white, viewing.white, 1e-3F, 1e6F, "the display's white is out of range");
    viewing.black = number(display.black, 0, 0, 1e6F, "the display's black is out of range");
    viewing.pixels_per_degree =
        number(display.pixels_per_degree, viewing.pixels_per_degree, 1, 1e4F, "pixels_per_degree are out of range");
    return viewing;
}

bool all_finite(std::span<const float> values) {
    return std::all_of(values.begin(), values.end(), [](float value) { return std::isfinite(value); });
}

ViewCurves convert_curves(const gg_curves& curves) {
    require(curves.values != nullptr && curves.size >= 2 && curves.size <= 65536, "the curves' size is out of range");
    const std::size_t size = curves.size;
    require(all_finite({curves.values, 3 * size}) && all_finite(curves.range) && all_finite(curves.slopes) &&
                all_finite(curves.black) && all_finite(curves.white) && curves.range[0] < curves.range[1],
            "the curves are not finite or have no range");
    ViewCurves result;
    result.lower = curves.range[0];
    result.upper = curves.range[1];
    for (std::size_t k = 0; k < 3; ++k) {
        const float* values = curves.values + k * size;
        result.channels[k] = {
            {values, values + size}, curves.slopes[2 * k], curves.slopes[2 * k + 1], curves.black[k], curves.white[k]};
    }
    return result;
}

}  // namespace

DisplaySettings convert_display(const gg_display& display) {
    return {text(display.config),
            text(display.device),
            text(display.view),
            text(display.look),
            number(display.exposure, 0, -64, 64, "the display's exposure is out of range"),
            number(display.gamma, 1, 0.01F, 100, "the display's gamma is out of range"),
            display.curves != nullptr ? std::optional(convert_curves(*display.curves)) : std::nullopt};
}

RenderSettings convert_settings(const gg_camera* camera, const gg_settings& settings) {
    if (camera == nullptr) {
        throw Error(GG_INVALID_SCENE, "there is no camera");
    }
    require(settings.method >= GG_METHOD_GATHER && settings.method <= GG_METHOD_FULL, "unknown method");
    require(settings.width >= 1 && settings.width <= kLargestPicture, "width is out of range");
    require(settings.height >= 1 && settings.height <= kLargestPicture, "height is out of range");
    require(settings.samples <= 256, "samples are out of range");
    require(settings.filter_type >= 0 && settings.filter_type <= 2, "unknown filter_type");
    require(settings.sites >= 0 && settings.sites <= GG_SITES_GRID, "unknown sites");
    require(settings.receivers >= 0 && settings.receivers <= GG_RECEIVERS_FREE_SPACE, "unknown receivers");
    require(settings.depth_law >= 0 && settings.depth_law <= GG_DEPTH_RECIPROCAL, "unknown depth_law");
    require(settings.gather_samples == 0 || (settings.gather_samples >= 16 && settings.gather_samples <= 4096),
            "gather_samples are out of range");
    require(settings.passes >> kPassCount == 0, "unknown passes");
    require(settings.threads >= 0 && settings.threads <= 4096, "threads are out of range");

    RenderSettings result;
    result.method = static_cast<Method>(settings.method);
    result.camera = convert_camera(*camera);
    result.width = settings.width;
    result.height = settings.height;
    result.view.crop = convert_crop(settings);
    result.passes.bits = settings.passes;
    result.view.samples = settings.samples == 0 ? 16 : settings.samples;
    result.view.exposure = number(settings.exposure, 1, 0, 1e30F, "exposure is out of range");
    result.view.film_transparent = settings.film_transparent != 0;
    result.filter_type = static_cast<FilterType>(settings.filter_type);
    result.filter_width = number(settings.filter_width, 1.5F, 0.01F, 100, "filter_width is out of range");
    result.quality = number(settings.quality, 0.02F, 0.001F, 1, "quality is out of range");
    const GatherSettings standard;
    result.gather.surfaces = settings.sites == GG_SITES_SURFACES_AND_GRID;
    result.gather.free_space = settings.receivers == GG_RECEIVERS_FREE_SPACE;
    result.gather.shared = !result.gather.free_space;  // which only the paper does
    result.gather.law = settings.depth_law == GG_DEPTH_RECIPROCAL ? DepthLaw::kReciprocal : DepthLaw::kLogarithmic;
    result.gather.cell = number(settings.cell_size, standard.cell, 4, 200, "cell_size is out of range");
    result.gather.threshold = number(settings.threshold, standard.threshold, 1e-4F, 1, "threshold is out of range");
    result.gather.samples = settings.gather_samples == 0 ? standard.samples : static_cast<int>(settings.gather_samples);
    if (settings.display != nullptr) {
        result.display = convert_display(*settings.display);
        result.viewing = convert_viewing(*settings.display);
    }
    result.noticeable = number(settings.noticeable, result.noticeable, 0.01F, 100, "noticeable is out of range");
    result.masking = settings.use_masking != 0;
    // More threads than cores would only make TBB print a warning.
    result.threads = std::min(settings.threads, static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
    return result;
}

}  // namespace gg
