// The converged lighting of a scene: what the picture and the final gather read.
#pragma once

#include <cstdint>
#include <memory>

#include "core/vec.h"

namespace gg {

struct Solution;  // radiosity/solution_data.h; immutable, may be read by many threads

// Irradiance [W/m2] at a point of a triangle's front or back, interpolated between the vertices of the elements around
// it: continuous across elements, T-vertices and triangles that share a shading vertex. `barycentric` are the weights
// of corners 1 and 2. 0 where no light was linked.
[[nodiscard]] Rgb interpolated_irradiance(const Solution& solution, std::uint32_t instance, std::uint32_t triangle,
                                          bool back, Vec2 barycentric);

}  // namespace gg
