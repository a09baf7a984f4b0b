// Slow truth for a final gather: dense rays from a point into a radiosity solution. Knows no sites, cuts or links.
#pragma once

#include <cstdint>

#include "core/vec.h"
#include "radiosity/solution.h"
#include "trace/ray_tracer.h"

namespace gg::oracle {

// Irradiance [W/m2] on unit normal n at a point off its surface: the radiosity of what `rays` directions meet, the
// world where they meet nothing, and of every lamp as many points.
[[nodiscard]] Vec3d solution_irradiance(const Solution& solution, const RayTracer& tracer, Vec3 x, Vec3 n,
                                        std::uint32_t rays);

}  // namespace gg::oracle
