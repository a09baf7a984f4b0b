// The picture of the radiosity solution as it stands: interpolated irradiance times texture, plus emission.
#pragma once

#include <cstdint>
#include <functional>

#include "core/vec.h"
#include "film/camera.h"
#include "film/film.h"
#include "film/pixel_filter.h"
#include "scene/scene.h"
#include "trace/ray_tracer.h"

namespace gg {

class Control;
class SurfaceColors;

struct ViewSettings {
    Rectangle crop;                 // of the full picture; has the film's size
    std::uint32_t samples = 16;     // coverage samples a pixel
    float exposure = 1;             // factor on every pixel
    bool film_transparent = false;  // what shows nothing but the world is (0, 0, 0, 0)
};

// Irradiance [W/m2] where a ray met a surface, at its front or back. Called by many threads at once.
using IrradianceAt = std::function<Rgb(const Hit& hit, bool back)>;

// Lamps are not seen: in Cycles they are hidden from the camera unless the user says otherwise.
struct View {
    const Scene& scene;
    const RayTracer& tracer;
    const SurfaceColors& colors;
    IrradianceAt irradiance_at;
    PixelCamera camera;
    PixelFilter filter;
    ViewSettings settings;
};

struct ViewCounts {
    std::uint64_t samples = 0;
    std::uint64_t dropped = 0;  // samples that were not finite; a pixel is the mean of its others
};

// Fills every tile of the film. Reports stage progress. Throws Cancelled between tiles.
ViewCounts render_view(const View& view, Film& film, Control& control);

}  // namespace gg
