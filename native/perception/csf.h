// Contrast sensitivity: how well an eye sees gratings of a spatial frequency.
#pragma once

namespace gg {

// Reciprocal of the least visible contrast [Barten 1989, as in Ramasubramanian et al. 1999]. frequency: cycles/degree,
// > 0. adaptation: cd/m2, > 0.
[[nodiscard]] float contrast_sensitivity(float frequency, float adaptation);

// The largest sensitivity there is at 100 cd/m2, to 3.248 cycles/degree.
inline constexpr float kPeakSensitivity = 525.15F;

}  // namespace gg
