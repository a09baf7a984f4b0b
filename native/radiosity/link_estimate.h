// What passes between two nodes: form factor, visibility, occluders and their error, from few samples.
#pragma once

#include "radiosity/exchange.h"
#include "radiosity/hierarchy.h"
#include "radiosity/lighting.h"
#include "radiosity/link.h"
#include "trace/ray_tracer.h"

namespace gg {

// Independent sets of samples. A link that is judged by the samples that it is made of comes out too dark: of all pairs
// that let a little light through, those pass for good whose rays happened to see nothing.
enum class SampleSet : std::uint8_t { kJudge, kLink };

// Samples the transport with about `rays` shadow rays, 4..64. receiver and sender may be one cluster. The hits of a
// near link are appended to `hits`, when given; with `lighting` the sender need not be even.
[[nodiscard]] Link estimate_link(const Hierarchy& hierarchy, const RayTracer& tracer, NodeId receiver, NodeId sender,
                                 int rays, SampleSet samples, NearHits* hits, const Lighting* lighting = nullptr);

}  // namespace gg
