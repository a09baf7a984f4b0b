// Which fragments show the same surface.
#pragma once

#include <cmath>

#include "core/vec.h"
#include "film/fragments.h"

namespace gg {

// Leaves of one plant that lie behind one another are not.
[[nodiscard]] inline bool is_same_surface(const Fragment& a, const Fragment& b) {
    constexpr float kSameSurface = 0.9F;  // cosine between normals
    constexpr float kOffPlane = 0.5F;     // sine of the angle to the surface under which the other one lies, at most
    const Vec3 across = b.position - a.position;
    return a.hit.instance == b.hit.instance && a.back == b.back && dot(a.normal, b.normal) > kSameSurface &&
           std::abs(dot(across, a.normal)) <= kOffPlane * length(across);
}

}  // namespace gg
