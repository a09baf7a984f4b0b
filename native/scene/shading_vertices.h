// Corners that share position and normal become one shading vertex: light varies smoothly there, and jumps elsewhere.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"
#include "scene/scene.h"

namespace gg {

struct ShadingVertices {
    std::vector<TriangleCorners> triangles;  // into normals
    std::vector<Vec3> normals;               // of the first corner that made the vertex
};

// corner_normals: 3 unit vectors per triangle. welded: first vertex at the position of each, see weld_positions.
// Normals that differ by at most `tolerance` (length of the difference) are the same. Linear time: at a vertex with
// very many different normals (the tip of a faceted cone) only the latest 32 are compared.
[[nodiscard]] ShadingVertices make_shading_vertices(std::span<const TriangleCorners> triangles,
                                                    std::span<const std::uint32_t> welded,
                                                    std::span<const Vec3> corner_normals, float tolerance);

}  // namespace gg
