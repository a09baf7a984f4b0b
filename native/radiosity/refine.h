// Refinement: which pairs of nodes exchange light by a link of their own.
#pragma once

#include <vector>

#include "radiosity/hierarchy.h"
#include "radiosity/lighting.h"
#include "radiosity/link.h"
#include "radiosity/reference_white.h"
#include "trace/ray_tracer.h"

namespace gg {

class Control;
class Statistics;

struct RefineSettings {
    float tolerance = 0.02F;  // allowed error of a link as a share of the reference white
    ReferenceWhite white;
};

// Pairs that every refinement starts from: the geometry with itself, with every lamp and with the sky.
[[nodiscard]] Links initial_links(const Hierarchy& hierarchy);

// Replaces links whose error exceeds the tolerance by links between children, opening nodes as needed, until none does
// or nodes are at their smallest. Every receiving point stays linked to every sending point exactly once; pairs that
// can never exchange light are left out.
void refine(Hierarchy& hierarchy, Lighting& lighting, const RayTracer& tracer, Links& links,
            const RefineSettings& settings, const Control& control, Statistics& statistics);

}  // namespace gg
