#include "trace/surface_point.h"

#include <limits>

namespace gg {

SurfacePoint surface_point(const Scene& scene, std::uint32_t instance, std::uint32_t triangle, float u, float v) {
    const Instance& placed = scene.instances[instance];
    const Mesh& mesh = scene.meshes[placed.mesh];
    const TriangleCorners& corners = mesh.triangles[triangle];
    const Vec3 p0 = mesh.positions[corners[0]];
    const Vec3 p1 = mesh.positions[corners[1]];
    const Vec3 p2 = mesh.positions[corners[2]];
    const float w = 1 - u - v;

    SurfacePoint point;
    point.position = placed.to_world.point(w * p0 + u * p1 + v * p2);
    point.geometric_normal = normalize_or_zero(placed.normal_to_world * cross(p1 - p0, p2 - p0));
    point.shading_normal = point.geometric_normal;
    if (!mesh.normals.empty()) {
        const TriangleCorners& shading = mesh.shading_vertices[triangle];
        const Vec3 blend = w * mesh.normals[shading[0]] + u * mesh.normals[shading[1]] + v * mesh.normals[shading[2]];
        const Vec3 normal = normalize_or_zero(placed.normal_to_world * blend);
        if (dot(normal, point.geometric_normal) > 0) {
            point.shading_normal = normal;
        }
    }
    if (!mesh.uvs.empty()) {
        const Vec2* uvs = &mesh.uvs[std::size_t{3} * triangle];
        point.uv = w * uvs[0] + u * uvs[1] + v * uvs[2];
    }
    return point;
}

Vec3 offset_origin(Vec3 position, Vec3 normal, float scale) {
    constexpr float kUlps = 32 * std::numeric_limits<float>::epsilon();
    const float rounding = kUlps * max_component(glm::abs(position));
    return position + std::max(1e-4F * scale, rounding) * normal;
}

}  // namespace gg
