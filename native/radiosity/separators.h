// Elements on which something stands that keeps the light of one part from another.
#pragma once

#include "radiosity/hierarchy.h"
#include "radiosity/lighting.h"
#include "radiosity/refine.h"
#include "trace/ray_tracer.h"

namespace gg {

class Control;

// A floor or a wall may go on behind a partition into a dark room. Opens leaf elements with points between which
// something stands and that see more different light than the tolerance allows, until there are none or they are at
// their smallest. Links stay as they are.
void split_at_separators(Hierarchy& hierarchy, Lighting& lighting, const RayTracer& tracer,
                         const RefineSettings& settings, const Control& control);

}  // namespace gg
