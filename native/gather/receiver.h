// A visible point near a site.
#pragma once

#include "core/vec.h"
#include "radiosity/solution.h"

namespace gg {

struct Receiver {
    Vec3 position{0.0F};        // off its surface
    Vec3 normal{0.0F};          // unit, geometric, of the side that is seen
    Vec3 shading_normal{0.0F};  // unit, of that side
    NodeId place = kNone;
    float reflectance = 0;  // luminance, 0..1
    float irradiance = 0;   // by the radiosity solution, luminance, W/m2

    [[nodiscard]] bool faces(Vec3 direction) const {
        return dot(normal, direction) > 0 && dot(shading_normal, direction) > 0;
    }
};

}  // namespace gg
