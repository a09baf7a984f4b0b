// A point of a surface in world space, from ids and barycentric weights.
#pragma once

#include <cstdint>

#include "core/vec.h"
#include "scene/scene.h"
#include "trace/ray_tracer.h"

namespace gg {

struct SurfacePoint {
    Vec3 position{0.0F};
    Vec3 geometric_normal{0.0F};  // unit, in front; zero when the placement leaves the triangle no area
    Vec3 shading_normal{0.0F};    // unit, in front
    Vec2 uv{0.0F};
};

// u, v: weights of corners 1 and 2.
[[nodiscard]] SurfacePoint surface_point(const Scene& scene, std::uint32_t instance, std::uint32_t triangle, float u,
                                         float v);
[[nodiscard]] inline SurfacePoint surface_point(const Scene& scene, const Hit& hit) {
    return surface_point(scene, hit.instance, hit.triangle, hit.u, hit.v);
}

// Moves the origin of a ray off its surface to the side to which unit `normal` points: by 1e-4 of `scale` (the ray's
// length or the surface's size, m), and by no less than what rounding can move a point so far from the world's origin.
[[nodiscard]] Vec3 offset_origin(Vec3 position, Vec3 normal, float scale);

}  // namespace gg
