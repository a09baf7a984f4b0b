#include "support/surface_meshes.h"

#include <algorithm>

namespace gg::test {

SceneDescription lit_floor() {
    SceneBuilder builder;
    builder.quad({-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}, builder.material(Rgb(0.5F)), "floor");
    builder.area_light({1, 0.5F, 0.4F}, {0, 0, -1}, 0.1F, Rgb(100));
    return builder.description;
}

SurfaceMesh::LengthOf even(float side) {
    return [side](Vec3 a, Vec3 b) { return length(b - a) / side; };
}

std::vector<SurfaceSpot> raster(const Scene& scene, std::uint32_t instance, int size) {
    std::vector<SurfaceSpot> spots;
    for (std::uint32_t t = 0; t < scene.meshes[scene.instances[instance].mesh].triangles.size(); ++t) {
        for (int i = 0; i < size; ++i) {
            for (int j = 0; i + j < size; ++j) {
                for (const Vec2 inside : {Vec2(0.31F, 0.37F), Vec2(0.69F, 0.63F)}) {
                    const Vec2 place = (Vec2(i, j) + inside) / static_cast<float>(size);
                    if (place.x + place.y < 1) {
                        spots.push_back({instance, t, false, place});
                    }
                }
            }
        }
    }
    return spots;
}

SurfaceMesh divided(const Solution& solution, const SurfaceMesh::Settings& settings,
                    const std::vector<SurfaceSpot>& spots) {
    SurfaceMesh mesh(solution, settings);
    std::vector<SurfacePart> seen;
    for (const SurfaceSpot& spot : spots) {
        seen.push_back(mesh.part_at(spot));
    }
    std::sort(seen.begin(), seen.end());
    seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
    mesh.divide(seen);
    return mesh;
}

Vec3 position_of(const Scene& scene, const SurfaceSpot& spot) {
    const auto c = world_triangle(scene, spot.instance, spot.triangle);
    return c[0] + spot.barycentric.x * (c[1] - c[0]) + spot.barycentric.y * (c[2] - c[0]);
}

}  // namespace gg::test
