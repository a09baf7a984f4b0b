// The rough picture that the radiosity solution gives of what is seen, with all textures: what an eye will be used to,
// and what patterns it will see, before the light is worked out.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "film/fragments.h"

namespace gg {

class Control;

// Irradiance of a fragment [W/m2]; called by many threads at once.
using FragmentIrradiance = std::function<Rgb(const Fragment&)>;

// Scene-linear pixels, row by row from the lower left of the crop. tiles: of all of it. Throws Cancelled.
[[nodiscard]] std::vector<Rgb> radiosity_view(const View& view, std::span<const TileFragments> tiles,
                                              const FragmentIrradiance& irradiance_of, const Control& control);

}  // namespace gg
