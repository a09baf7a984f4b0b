// Visibility between two nodes, by rays between points of both.
#pragma once

#include <array>
#include <cstdint>

#include "radiosity/link_estimate.h"
#include "radiosity/near_link.h"
#include "radiosity/quarter.h"

namespace gg {

// Rays between points of two nodes that face each other.
struct ShadowRays {
    std::array<Ray, kMaxRays> rays;
    std::array<float, kMaxRays> weights{};          // of the unoccluded transport
    std::array<float, kMaxRays> lengths{};          // m
    std::array<Vec3, kMaxRays> targets;             // on the sender
    std::array<std::uint8_t, kMaxRays> quarters{};  // of an element, from which they start
    std::size_t count = 0;
    bool sender_shines = false;  // some point of the sender faces some point of the receiver, if not the reverse
};

// What the shadow rays of a link saw, for the whole receiver and for the quarters of an element.
struct Seen {
    float visibility = 0;
    float near_share = 0;  // of what arrives: over less than the reach of patches
    std::array<float, kQuarters> quarters{};
    float sampling_error = 0;                      // of visibility
    std::array<std::uint8_t, kMaxRays> blocked{};  // per ray
};

// At most `count` rays (<= kMaxRays): pairs of points that do not face each other get none.
[[nodiscard]] ShadowRays make_shadow_rays(const Hierarchy& hierarchy, const Node& receiver, const Node& sender,
                                          int count, SampleSet samples);

// `count` as given to make_shadow_rays.
[[nodiscard]] Seen trace_shadow_rays(const RayTracer& tracer, const ShadowRays& pairs, int count, float reach);

// Sets where the link's occluders are, seen from the receiver.
void find_occluders(const Hierarchy& hierarchy, const RayTracer& tracer, const ShadowRays& pairs, const Seen& seen,
                    Link& link);

}  // namespace gg
