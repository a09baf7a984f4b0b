// Slow truth for the visibility of links: many random pairs of points, one ray each.
#pragma once

#include <cstdint>

#include "radiosity/hierarchy.h"
#include "trace/ray_tracer.h"

namespace gg::oracle {

// Share of the light from sender to receiver (a surface node) that nothing blocks, 0..1: pairs of points even over
// both, weighted by their cosines and distances. Negative when no pair faced each other.
[[nodiscard]] double counted_visibility(const Hierarchy& hierarchy, const RayTracer& tracer, NodeId receiver,
                                        NodeId sender, std::uint32_t pairs, std::uint64_t seed);

}  // namespace gg::oracle
