// Elements that end where another surface begins.
#pragma once

#include "radiosity/hierarchy.h"
#include "radiosity/lighting.h"
#include "radiosity/refine.h"
#include "trace/ray_tracer.h"

namespace gg {

class Control;

// Along the edge between a wall and a ceiling light falls off over a short way, and links between the large elements on
// both sides see little of that: each sends about what the other does. Opens leaf elements beside which something
// stands and whose light bends by more than the tolerance allows, until there are none or they are small.
// Links stay as they are.
void split_at_creases(Hierarchy& hierarchy, Lighting& lighting, const RayTracer& tracer, const RefineSettings& settings,
                      const Control& control);

}  // namespace gg
