// What surfaces send must arrive.
#pragma once

#include "radiosity/face_light.h"
#include "radiosity/lighting.h"

namespace gg {

class Control;
class RayTracer;

// By what to multiply the gain of the links, so that elements get what surfaces send, less what misses everything or
// is sent to clusters, whose faces know it. Links are estimated one by one; a few per cent that they lose together
// would be lost anew with every reflection. Near 1: within kMostCorrection.
[[nodiscard]] float missing_gain(const Hierarchy& hierarchy, const Lighting& lighting, const FaceLight& faces,
                                 const RayTracer& tracer, const Control& control);

}  // namespace gg
