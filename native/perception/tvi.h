// Threshold versus intensity: which difference in luminance an eye just sees that is adapted to a luminance.
#pragma once

namespace gg {

// cd/m2; eyes that are used to less are taken to be used to this.
inline constexpr float kDarkestAdaptation = 1e-5F;

// The least visible difference of a small spot [cd/m2]. adaptation: luminance [cd/m2], >= 0. Rods and cones together,
// in five pieces that join within 3 % [Ward Larson et al. 1997, after Ferwerda et al. 1996].
[[nodiscard]] float just_noticeable(float adaptation);

}  // namespace gg
