#include "core/distance.h"

#include <algorithm>
#include <cmath>

namespace gg {

float distance_to_triangle(Vec3 p, const std::array<Vec3, 3>& corners) {
    const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    float nearest = kInfinity;
    bool inside = length_squared(normal) > 0;
    for (int k = 0; k < 3; ++k) {
        const Vec3 a = corners[k];
        const Vec3 along = corners[(k + 1) % 3] - a;
        inside = inside && dot(cross(along, p - a), normal) >= 0;
        const float t = std::clamp(dot(p - a, along) / std::max(length_squared(along), 1e-30F), 0.0F, 1.0F);
        nearest = std::min(nearest, length(p - a - t * along));
    }
    return inside ? std::abs(dot(p - corners[0], normal)) / length(normal) : nearest;
}

}  // namespace gg
