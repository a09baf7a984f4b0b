// What can be said of two nodes without a ray.
#pragma once

#include "radiosity/hierarchy.h"

namespace gg {

// True when no light can pass whatever lies between: one is behind the other, or a lamp does not shine there.
[[nodiscard]] bool never_exchange(const Hierarchy& hierarchy, const Node& receiver, const Node& sender);

// Upper bound of the form factor (of a `near` link for clusters that touch: 1), without a ray. Its unit is that of a
// surface sender's: multiply by the mean radiosity.
[[nodiscard]] float form_factor_bound(const Hierarchy& hierarchy, const Node& receiver, const Node& sender);

// The sky, and lamps as far away: without a distance.
[[nodiscard]] bool is_infinite(const Hierarchy& hierarchy, const Node& sender);

// Bounding spheres apart: far-field formulas hold.
[[nodiscard]] bool separated(const Node& receiver, const Node& sender);

enum class SpotEdge { kInside, kCrosses, kOutside };

// Where a receiver lies to the edge of a spot's cone.
[[nodiscard]] SpotEdge spot_edge(const Node& receiver, const Lamp& lamp);

}  // namespace gg
