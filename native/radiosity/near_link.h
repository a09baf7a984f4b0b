// Links between clusters that touch, or of a cluster with itself: found by rays from the receiver's faces.
#pragma once

#include "core/random.h"
#include "radiosity/link_estimate.h"

namespace gg {

inline constexpr int kMaxRays = 64;  // of one link

// That no ray, or every ray, was blocked is no proof: the standard deviation of a share of which n samples said the
// same is 1 / (n + 2) for a uniform prior; most pairs of a scene are simple, so half of it.
inline constexpr float kUnproven = 0.5F;

// Dimensions 0..2 for the point on the receiver, 3..5 for that on the sender or the direction.
[[nodiscard]] Sequence6 pair_sequence(const Node& receiver, const Node& sender, SampleSet samples);

// Fills the link with the share of the hemispheres above the receiver's faces that the sender fills, by `count` rays.
void estimate_near(const Hierarchy& hierarchy, const RayTracer& tracer, const Node& receiver, const Node& sender,
                   int count, SampleSet samples, Link& link, NearHits* out);

}  // namespace gg
