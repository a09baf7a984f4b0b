// Neighbouring elements of about the same size.
#pragma once

#include "radiosity/hierarchy.h"
#include "radiosity/lighting.h"

namespace gg {

class Control;

// Opens leaf elements of which a neighbour on the same mesh is divided twice more than they are, until there are none:
// what is interpolated would else spread a speck of light over all of a large neighbour.
void balance_elements(Hierarchy& hierarchy, Lighting& lighting, const Control& control);

}  // namespace gg
