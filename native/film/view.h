// What a picture is made from, but for its light.
#pragma once

#include <cstdint>

#include "film/camera.h"
#include "film/film.h"
#include "film/pixel_filter.h"
#include "scene/scene.h"
#include "trace/ray_tracer.h"

namespace gg {

class SurfaceColors;

struct ViewSettings {
    Rectangle crop;                 // of the full picture; has the film's size
    std::uint32_t samples = 16;     // coverage samples a pixel
    float exposure = 1;             // factor on every pixel
    bool film_transparent = false;  // what shows nothing but the world is (0, 0, 0, 0)
};

// Lamps are not seen: in Cycles they are hidden from the camera unless the user says otherwise.
struct View {
    const Scene& scene;
    const RayTracer& tracer;
    const SurfaceColors& colors;
    PixelCamera camera;
    PixelFilter filter;
    ViewSettings settings;
};

}  // namespace gg
