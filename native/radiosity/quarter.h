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

}  // namespace gg
