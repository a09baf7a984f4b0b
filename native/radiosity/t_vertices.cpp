#include "radiosity/t_vertices.h"

#include <algorithm>
#include <utility>

namespace gg {

namespace {

std::uint32_t find_midpoint(const Midpoints& midpoints, std::uint32_t a, std::uint32_t b) {
    const auto found = midpoints.find(edge_key(a, b));
    return found == midpoints.end() ? kNone : found->second;
}

// Weights of the corners 1 and 2 of a piece at a place.
Vec2 weights_in(const Piece& piece, Vec2 place) {
    const Vec2 e1 = piece.places[1] - piece.places[0];
    const Vec2 e2 = piece.places[2] - piece.places[0];
    const Vec2 p = place - piece.places[0];
    const float determinant = e1.x * e2.y - e1.y * e2.x;
    return Vec2(p.x * e2.y - p.y * e2.x, e1.x * p.y - e1.y * p.x) / determinant;
}

}  // namespace

std::uint64_t edge_key(std::uint32_t a, std::uint32_t b) {
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | std::max(a, b);
}

Corners opposite_midpoints(const Midpoints& midpoints, const Corners& c) {
    return {find_midpoint(midpoints, c[1], c[2]), find_midpoint(midpoints, c[2], c[0]),
            find_midpoint(midpoints, c[0], c[1])};
}

Corners make_midpoints(Midpoints& midpoints, std::size_t mesh_vertices, const Corners& corners) {
    Corners opposite;
    for (int k = 0; k < 3; ++k) {
        const auto next = static_cast<std::uint32_t>(mesh_vertices + midpoints.size());
        opposite[k] = midpoints.try_emplace(edge_key(corners[(k + 1) % 3], corners[(k + 2) % 3]), next).first->second;
    }
    return opposite;
}

Corners quarter_corners(const Corners& corners, const Corners& opposite, int quarter) {
    switch (quarter) {
        case 0:
            return {corners[0], opposite[2], opposite[1]};
        case 1:
            return {opposite[2], corners[1], opposite[0]};
        case 2:
            return {opposite[1], opposite[0], corners[2]};
        default:
            return {opposite[0], opposite[1], opposite[2]};
    }
}

Piece whole_piece(const Corners& corners) {
    return {corners, {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)}};
}

int split_at_t_vertices(const Midpoints& midpoints, const Piece& piece, std::array<Piece, 4>& parts) {
    const Corners middle = opposite_midpoints(midpoints, piece.vertices);
    const auto place = [&](int k) { return 0.5F * (piece.places[(k + 1) % 3] + piece.places[(k + 2) % 3]); };
    const int count = static_cast<int>(std::count_if(middle.begin(), middle.end(), [](auto m) { return m != kNone; }));
    if (count == 0) {
        return 1;
    }
    const auto corner = [&](int k) { return std::pair{piece.vertices[k % 3], piece.places[k % 3]}; };
    const auto mid = [&](int k) { return std::pair{middle[k % 3], place(k % 3)}; };
    const auto make = [](auto a, auto b, auto c) {
        return Piece{{a.first, b.first, c.first}, {a.second, b.second, c.second}};
    };
    if (count == 3) {
        parts = {make(corner(0), mid(2), mid(1)), make(mid(2), corner(1), mid(0)), make(mid(1), mid(0), corner(2)),
                 make(mid(0), mid(1), mid(2))};
        return 4;
    }
    if (count == 1) {
        const int k = middle[0] != kNone ? 0 : (middle[1] != kNone ? 1 : 2);
        parts[0] = make(corner(k), corner(k + 1), mid(k));
        parts[1] = make(corner(k), mid(k), corner(k + 2));
        return 2;
    }
    const int k = middle[0] == kNone ? 0 : (middle[1] == kNone ? 1 : 2);  // the edge opposite k is whole
    parts[0] = make(corner(k), mid(k + 2), mid(k + 1));
    parts[1] = make(mid(k + 2), corner(k + 1), mid(k + 1));
    parts[2] = make(corner(k + 1), corner(k + 2), mid(k + 1));
    return 3;
}

PlaceInPiece find_piece(const Midpoints& midpoints, Piece whole, Vec2 place) {
    std::array<Piece, 4> parts;
    for (;;) {
        const int count = split_at_t_vertices(midpoints, whole, parts);
        if (count == 1) {
            return {whole.vertices, weights_in(whole, place)};
        }
        int best = 0;
        float best_inside = -kInfinity;
        for (int i = 0; i < count; ++i) {
            const Vec2 w = weights_in(parts[i], place);
            const float inside = std::min({w.x, w.y, 1 - w.x - w.y});
            if (inside > best_inside) {
                best_inside = inside;
                best = i;
            }
        }
        whole = parts[best];
    }
}

}  // namespace gg
