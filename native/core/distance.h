// Distances between points and shapes.
#pragma once

#include <array>

#include "core/vec.h"

namespace gg {

// From p to the nearest point of a triangle, >= 0. A degenerate triangle counts as its edges.
[[nodiscard]] float distance_to_triangle(Vec3 p, const std::array<Vec3, 3>& corners);

}  // namespace gg
