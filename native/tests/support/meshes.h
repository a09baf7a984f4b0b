// Mesh descriptions for tests of the scene layer.
#pragma once

#include <cstdint>
#include <vector>

#include "core/vec.h"
#include "scene/description.h"

namespace gg::test {

// Unit-less mesh of triangles (3 vertex indices each), without corner data.
[[nodiscard]] MeshDescription make_mesh(std::vector<Vec3> positions, std::vector<std::uint32_t> triangle_vertices);

// Closed box of 12 triangles and 8 vertices, fronts outwards, or inwards.
[[nodiscard]] MeshDescription make_box(Vec3 lower, Vec3 upper, bool inward = false);

// The triangles of both; without corner data.
[[nodiscard]] MeshDescription join(const MeshDescription& a, const MeshDescription& b);

// The same triangles, where no two share a vertex.
[[nodiscard]] MeshDescription split(const MeshDescription& mesh);

// One corner per triangle and vertex, in order, with these normals and uvs (3 per triangle; may be empty).
void add_corners(MeshDescription& mesh, std::vector<Vec3> normals, std::vector<Vec2> uvs);

}  // namespace gg::test
