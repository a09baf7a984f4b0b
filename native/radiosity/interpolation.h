// From one irradiance per element to a continuous one: values at vertices, interpolated between them.
#pragma once

#include "radiosity/solution_data.h"

namespace gg {

class Control;

// Averages the irradiance of all elements and clusters that meet at a vertex. An edge whose neighbour is divided
// further takes part in that division (T-vertices become vertices of both sides), to any depth, so there are no cracks.
void interpolate_to_vertices(Solution& solution, const Control& control);

}  // namespace gg
