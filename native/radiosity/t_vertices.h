// Elements whose edges a neighbour divides: vertices on edges, and the triangles that they make of an element.
#pragma once

#include <array>
#include <cstdint>

#include "radiosity/solution_data.h"

namespace gg {

using Corners = std::array<std::uint32_t, 3>;  // vertices of InstanceVertices

// Key of InstanceVertices::midpoints.
[[nodiscard]] std::uint64_t edge_key(std::uint32_t a, std::uint32_t b);

// Corners of the quarter of a triangle whose edges have midpoints opposite[k] (opposite corner k); as make_quarter.
[[nodiscard]] Corners quarter_corners(const Corners& corners, const Corners& opposite, int quarter);

// Vertices between corners k+1 and k+2, made where there are none; mesh_vertices: number of the mesh's own.
[[nodiscard]] Corners opposite_midpoints(InstanceVertices& vertices, std::size_t mesh_vertices, const Corners& corners);

// A triangle of the picture: vertices, and their places in the whole (weights of corners 1 and 2).
struct Piece {
    Corners vertices;
    std::array<Vec2, 3> places;
};

[[nodiscard]] Piece whole_piece(const Corners& corners);

// Splits a leaf at the midpoints that its neighbours put on its edges. Returns the number of parts, 1 when none did.
// The pattern depends on the piece alone, so both users of it (averaging, look-up) see the same triangles.
[[nodiscard]] int split_at_t_vertices(const InstanceVertices& vertices, const Piece& piece,
                                      std::array<Piece, 4>& parts);

}  // namespace gg
