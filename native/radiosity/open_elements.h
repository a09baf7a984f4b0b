// Elements that are opened for what a closer look at each of them finds.
#pragma once

#include <functional>

#include "radiosity/hierarchy.h"
#include "radiosity/lighting.h"
#include "radiosity/refine.h"

namespace gg {

class Control;

using ElementTest = std::function<bool(NodeId)>;

// Opens leaf elements that pass the test, and their quarters in turn, until none does or they are at their smallest.
// make_test is called once for every block of elements: a test need not be safe for several threads. Links stay as they
// are.
void open_elements(Hierarchy& hierarchy, Lighting& lighting, const RefineSettings& settings,
                   const std::function<ElementTest()>& make_test, const Control& control);

}  // namespace gg
