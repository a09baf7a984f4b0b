// Elements on which the light of lamps ends.
#pragma once

#include "radiosity/hierarchy.h"
#include "radiosity/lighting.h"
#include "radiosity/refine.h"
#include "radiosity/source_guide.h"
#include "trace/ray_tracer.h"

namespace gg {

class Control;

// Links judge lamps one by one, by few rays for each pair, and a patch of sunlight on a floor escapes them; so does the
// sum of what many lamps do. Opens leaf elements whose quarters get more different light from lamps and glowing
// triangles than the tolerance allows, until none does or they are at their smallest. Links stay as they are.
void split_at_shadow_edges(Hierarchy& hierarchy, Lighting& lighting, const SourceGuide& guide, const RayTracer& tracer,
                           const RefineSettings& settings, const Control& control);

}  // namespace gg
