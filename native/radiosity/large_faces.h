// Faces that are too large for a cluster.
#pragma once

#include "radiosity/hierarchy.h"
#include "radiosity/lighting.h"

namespace gg {

class Control;

// Opens leaf clusters until none holds a face whose longest edge is at least so long [m]: a table's top has shadows of
// its own, however little light links bring it.
void open_large_faces(Hierarchy& hierarchy, Lighting& lighting, float edge, const Control& control);

}  // namespace gg
