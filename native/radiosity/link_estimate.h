// What passes between two nodes: form factor, visibility, occluders and their error, from few samples.
#pragma once

#include <vector>

#include "radiosity/hierarchy.h"
#include "radiosity/link.h"
#include "trace/ray_tracer.h"

namespace gg {

// True when no light can pass whatever lies between: one is behind the other, or a lamp does not shine there.
[[nodiscard]] bool never_exchange(const Hierarchy& hierarchy, const Node& receiver, const Node& sender);

// Upper bound of the form factor (of a `near` link for clusters that touch: 1), without a ray. Its unit is that of a
// surface sender's: multiply by the mean radiosity.
[[nodiscard]] float form_factor_bound(const Hierarchy& hierarchy, const Node& receiver, const Node& sender);

// Bounding spheres apart: far-field formulas hold.
[[nodiscard]] bool separated(const Node& receiver, const Node& sender);

// Independent sets of samples. A link that is judged by the samples that it is made of comes out too dark: of all pairs
// that let a little light through, those pass for good whose rays happened to see nothing.
enum class SampleSet : std::uint8_t { kJudge, kLink };

// Samples the transport with about `rays` shadow rays, 4..64. receiver and sender may be one cluster. The hits of a
// near link are appended to `hits`, when given.
[[nodiscard]] Link estimate_link(const Hierarchy& hierarchy, const RayTracer& tracer, NodeId receiver, NodeId sender,
                                 int rays, SampleSet samples, NearHits* hits);

}  // namespace gg
