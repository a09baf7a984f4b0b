#include "perception/csf.h"

#include <cmath>

namespace gg {

float contrast_sensitivity(float frequency, float adaptation) {
    const float a = 440 * std::pow(1 + 0.7F / adaptation, -0.2F);
    const float b = 0.3F * std::pow(1 + 100 / adaptation, 0.15F);
    const float falls = std::exp(-b * frequency);
    return a * frequency * falls * std::sqrt(1 + 0.06F / falls);
}

}  // namespace gg
