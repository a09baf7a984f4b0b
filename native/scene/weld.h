// Vertices at one position, found in linear time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"

namespace gg {

// For every vertex the first one with exactly its position (0 and -0 are equal). Positions must be finite.
[[nodiscard]] std::vector<std::uint32_t> weld_positions(std::span<const Vec3> positions);

}  // namespace gg
