// Shadow rays to sources of light.
#pragma once

#include "core/vec.h"
#include "radiosity/hierarchy.h"
#include "trace/ray_tracer.h"

namespace gg {

// Where shadow rays begin: already off the surface.
struct OffsetPoint {
    Vec3 position{0.0F}, normal{0.0F};
};

struct SourceRay {
    Ray ray;
    Rgb light{0.0F};  // irradiance [W/m2] that the whole source brings if nothing is in the way; 0: no ray is needed
};

// To a lamp, a cell of the sky or an element's own emission. sample: in [0, 1)^3. The mean over samples of the light of
// unblocked rays is the irradiance from the source.
[[nodiscard]] SourceRay ray_to_source(const Hierarchy& hierarchy, NodeId source, const OffsetPoint& x, Vec3 sample);

}  // namespace gg
