// What the solve measures errors against: how bright and how large the lit part of the scene is.
#pragma once

#include "radiosity/hierarchy.h"
#include "radiosity/lighting.h"

namespace gg {

// No camera and no exposure enters. Weighting by received light makes it blind to whatever lies in the dark, such as a
// ground plane that goes on for kilometres.
struct ReferenceWhite {
    float irradiance = 0;  // W/m2: half of all light falls where it is stronger, half where it is weaker
    float extent = 0;      // m: mean distance of the light's places from their centre
};

// From the light that the hierarchy's leaves receive; from the lamps and the size of the scene while none was gathered.
[[nodiscard]] ReferenceWhite reference_white(const Hierarchy& hierarchy, const Lighting& lighting);

}  // namespace gg
