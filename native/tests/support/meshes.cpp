#include "support/meshes.h"

#include <numeric>
#include <utility>

namespace gg::test {

MeshDescription make_mesh(std::vector<Vec3> positions, std::vector<std::uint32_t> triangle_vertices) {
    MeshDescription mesh;
    mesh.name = "mesh";
    mesh.positions = std::move(positions);
    mesh.triangle_vertices = std::move(triangle_vertices);
    return mesh;
}

MeshDescription make_box(Vec3 lower, Vec3 upper, bool inward) {
    std::vector<Vec3> positions;
    for (int corner = 0; corner < 8; ++corner) {
        positions.emplace_back(corner & 1 ? upper.x : lower.x, corner & 2 ? upper.y : lower.y,
                               corner & 4 ? upper.z : lower.z);
    }
    MeshDescription mesh = make_mesh(positions, {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                                 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5});
    for (std::size_t first = 0; first < mesh.triangle_vertices.size() && inward; first += 3) {
        std::swap(mesh.triangle_vertices[first + 1], mesh.triangle_vertices[first + 2]);
    }
    return mesh;
}

MeshDescription join(const MeshDescription& a, const MeshDescription& b) {
    MeshDescription mesh = make_mesh(a.positions, a.triangle_vertices);
    mesh.positions.insert(mesh.positions.end(), b.positions.begin(), b.positions.end());
    for (const std::uint32_t vertex : b.triangle_vertices) {
        mesh.triangle_vertices.push_back(vertex + static_cast<std::uint32_t>(a.positions.size()));
    }
    return mesh;
}

MeshDescription split(const MeshDescription& mesh) {
    MeshDescription result;
    result.name = mesh.name;
    for (const std::uint32_t vertex : mesh.triangle_vertices) {
        result.positions.push_back(mesh.positions[vertex]);
    }
    result.triangle_vertices.resize(result.positions.size());
    std::iota(result.triangle_vertices.begin(), result.triangle_vertices.end(), 0U);
    return result;
}

void add_corners(MeshDescription& mesh, std::vector<Vec3> normals, std::vector<Vec2> uvs) {
    mesh.triangle_corners.resize(mesh.triangle_vertices.size());
    std::iota(mesh.triangle_corners.begin(), mesh.triangle_corners.end(), 0U);
    mesh.corner_normals = std::move(normals);
    mesh.corner_uvs = std::move(uvs);
}

}  // namespace gg::test
