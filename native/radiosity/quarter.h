// Quarters of a triangle. Quarter 0..2 keeps corner 0..2 in its place, quarter 3 is the middle one:
//
//        2
//       / \          each quarter has the whole's orientation
//      /_2_\         and a quarter of its area
//     / \3/ \        .
//    /_0_V_1_\       .
//   0         1
#pragma once

#include <array>

#include "core/vec.h"

namespace gg {

inline constexpr int kQuarters = 4;

// The corners of a quarter, or what is linear over the triangle, at them.
template <typename Value>
[[nodiscard]] std::array<Value, 3> quarter_of(const std::array<Value, 3>& corners, int quarter) {
    std::array<Value, 3> part;
    for (int k = 0; k < 3; ++k) {
        const int self = quarter == 3 ? (k + 2) % 3 : k;
        const int other = quarter == 3 ? (k + 1) % 3 : quarter;
        part[k] = 0.5F * (corners[self] + corners[other]);
    }
    return part;
}

// The quarter at a point, given by its weights of corners 1 and 2.
[[nodiscard]] inline int quarter_at(Vec2 place) {
    if (place.x >= 0.5F) {
        return 1;
    }
    if (place.y >= 0.5F) {
        return 2;
    }
    return place.x + place.y <= 0.5F ? 0 : 3;
}

// The same point in the quarter's own coordinates.
[[nodiscard]] inline Vec2 place_in_quarter(Vec2 place, int quarter) {
    switch (quarter) {
        case 0:
            return 2.0F * place;
        case 1:
            return {2 * place.x - 1, 2 * place.y};
        case 2:
            return {2 * place.x, 2 * place.y - 1};
        default:
            return {1 - 2 * place.x, 1 - 2 * place.y};
    }
}

}  // namespace gg
