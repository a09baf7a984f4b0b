// Decides what to do with a pair of nodes; the refinement does it.
#pragma once

#include "radiosity/hierarchy.h"
#include "radiosity/lighting.h"
#include "radiosity/link.h"
#include "radiosity/refine.h"
#include "trace/ray_tracer.h"

namespace gg {

enum class Verdict : std::uint8_t { kAccept, kDrop, kSplitReceiver, kSplitSender, kSplitSelf };

struct Decision {
    Verdict verdict = Verdict::kDrop;
    Link link;  // of kAccept; its hits are appended to those given to decide()
};

// Diameter over that of a detail. The light of larger receivers counts in full.
[[nodiscard]] float size_in_details(float radius, const RefineSettings& settings);

// Difference of radiosity that may go unnoticed [W/m2]: an equal step in the square root of irradiance, which is about
// an equal step in display code, so that dim rooms are solved as well as bright ones.
[[nodiscard]] float allowed_difference(float irradiance, const RefineSettings& settings);

// Error that may be made in the radiosity of a receiver [W/m2]: more where it is small.
[[nodiscard]] float allowed_error(const Node& receiver, float irradiance, const RefineSettings& settings);

// The square root of reflectance for the same reason: a dark surface is compared with itself.
[[nodiscard]] float seen_reflectance(const Node& node);

// Not yet at its smallest.
[[nodiscard]] bool can_split(const Node& node, const RefineSettings& settings);

// Whether a link that was estimated earlier still holds with the light of now. Traces nothing.
[[nodiscard]] bool still_good(const Hierarchy& hierarchy, const Lighting& lighting, const Link& link,
                              const RefineSettings& settings);

// Whether what the receiver sees of an element may have become brighter or darker than the element's mean.
[[nodiscard]] bool may_be_uneven(const Hierarchy& hierarchy, const Lighting& lighting, const Link& link,
                                 const RefineSettings& settings);

[[nodiscard]] Decision decide(const Hierarchy& hierarchy, const Lighting& lighting, const RayTracer& tracer,
                              NodeId receiver, NodeId sender, const RefineSettings& settings, NearHits& hits);

}  // namespace gg
