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

// Whether a link that was estimated earlier still holds with the light of now. Traces nothing.
[[nodiscard]] bool still_good(const Hierarchy& hierarchy, const Lighting& lighting, const Link& link,
                              const RefineSettings& settings);

// Whether what the receiver sees of an element may have become brighter or darker than the element's mean.
[[nodiscard]] bool may_be_uneven(const Hierarchy& hierarchy, const Lighting& lighting, const Link& link,
                                 const RefineSettings& settings);

[[nodiscard]] Decision decide(const Hierarchy& hierarchy, const Lighting& lighting, const RayTracer& tracer,
                              NodeId receiver, NodeId sender, const RefineSettings& settings, NearHits& hits);

}  // namespace gg
