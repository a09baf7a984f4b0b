// What rays of elements say of their light, taken as far as it is beyond doubt.
#pragma once

#include <span>

#include "radiosity/gathered_light.h"
#include "radiosity/lighting.h"

namespace gg {

class Control;

// Corrects the reflected light that comes to leaf elements, elements[i], by estimates[i]; direct[i] of what links bring
// is emitted. Single ones are too noisy; so the difference to what links bring is averaged over each element of the
// hierarchy, and from the whole triangle down every part differs from the whole only as far as the difference exceeds
// its noise.
void correct_elements(const Hierarchy& hierarchy, std::span<const NodeId> elements, std::span<const Rgb> direct,
                      std::span<const GatheredLight::Estimate> estimates, Lighting& lighting, const Control& control);

}  // namespace gg
