// Elements whose edges a neighbour divides: vertices on edges, and the triangles that they make of an element.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>

#include "core/vec.h"
#include "scene/description.h"

namespace gg {

using Corners = std::array<std::uint32_t, 3>;                        // vertices: of the mesh, then midpoints of edges
using Midpoints = std::unordered_map<std::uint64_t, std::uint32_t>;  // edge_key() of two vertices -> the one between

[[nodiscard]] std::uint64_t edge_key(std::uint32_t a, std::uint32_t b);  // in any order

// Corners of the quarter of a triangle whose edges have midpoints opposite[k] (opposite corner k); as make_quarter.
[[nodiscard]] Corners quarter_corners(const Corners& corners, const Corners& opposite, int quarter);

// Vertices between corners k+1 and k+2, made where there are none; mesh_vertices: number of the mesh's own.
[[nodiscard]] Corners make_midpoints(Midpoints& midpoints, std::size_t mesh_vertices, const Corners& corners);
// The same where all three are there.
[[nodiscard]] Corners opposite_midpoints(const Midpoints& midpoints, const Corners& corners);

// A triangle of the picture: vertices, and their places in the whole (weights of corners 1 and 2).
struct Piece {
    Corners vertices;
    std::array<Vec2, 3> places;
};

[[nodiscard]] Piece whole_piece(const Corners& corners);

// Splits a leaf at the midpoints that its neighbours put on its edges. Returns the number of parts, 1 when none did.
// The pattern depends on the piece alone, so both users of it (averaging, look-up) see the same triangles.
[[nodiscard]] int split_at_t_vertices(const Midpoints& midpoints, const Piece& piece, std::array<Piece, 4>& parts);

// A place in the part that needs no more splitting.
struct PlaceInPiece {
    Corners vertices{};
    Vec2 weights{0.0F};  // of vertices 1 and 2
};
// place: weights of corners 1 and 2 of the whole.
[[nodiscard]] PlaceInPiece find_piece(const Midpoints& midpoints, Piece whole, Vec2 place);

}  // namespace gg
