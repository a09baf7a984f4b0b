#include "film/sample_color.h"

#include <algorithm>
#include <cmath>

#include "material/surface_color.h"

namespace gg {

namespace {

// Twice the area of the triangle in texture coordinates.
float uv_area(const Mesh& mesh, std::uint32_t triangle) {
    const Vec2* uvs = &mesh.uvs[std::size_t{3} * triangle];
    const Vec2 a = uvs[1] - uvs[0];
    const Vec2 b = uvs[2] - uvs[0];
    return std::abs(a.x * b.y - a.y * b.x);
}

Vec2 uv_at(const Mesh& mesh, const Hit& hit) {
    const Vec2* uvs = &mesh.uvs[std::size_t{3} * hit.triangle];
    return (1 - hit.u - hit.v) * uvs[0] + hit.u * uvs[1] + hit.v * uvs[2];
}

}  // namespace

SampleColors colors_at(const View& view, const Ray& ray, const Hit& hit, float share) {
    const Instance& instance = view.scene.instances[hit.instance];
    const Mesh& mesh = view.scene.meshes[instance.mesh];
    const std::uint32_t material = view.scene.material_of(hit.instance, hit.triangle);
    Vec2 uv(0);
    float uv_width = 0;
    if (view.colors.is_textured(material) && !mesh.uvs.empty()) {
        uv = uv_at(mesh, hit);
        // A sample's share of its pixel covers size^2 / cos of the surface; textures average over a square like it.
        const TriangleCorners& corners = mesh.triangles[hit.triangle];
        const Vec3 p0 = mesh.positions[corners[0]];
        const Vec3 normal =
            instance.normal_to_world * cross(mesh.positions[corners[1]] - p0, mesh.positions[corners[2]] - p0);
        const float size = view.camera.pixel_size(hit.distance);
        const float across = std::abs(dot(normal, ray.direction)) / length(ray.direction);  // twice the area as seen
        uv_width = std::sqrt(share * size * size * uv_area(mesh, hit.triangle) / std::max(across, 1e-30F));
    }
    return {view.colors.reflectance_at(material, uv, uv_width), view.colors.emission_at(material, uv, uv_width)};
}

}  // namespace gg
