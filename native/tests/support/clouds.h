// Objects of many small faces, for which the solve uses clusters.
#pragma once

#include <cstdint>

#include "core/vec.h"
#include "scene/description.h"

namespace gg::test {

// Equilateral triangles with centres even in the box and turned at random: open sheets, like leaves.
[[nodiscard]] MeshDescription triangle_cloud(const Box& box, std::uint32_t count, float edge, std::uint64_t seed);

// Closed cubes with centres even in the box and turned at random.
[[nodiscard]] MeshDescription cube_cloud(const Box& box, std::uint32_t count, float edge, std::uint64_t seed);

}  // namespace gg::test
