// The picture of the radiosity solution as it stands: interpolated irradiance times texture, plus emission.
#pragma once

#include <cstdint>

#include "film/fragments.h"

namespace gg {

class Control;

struct ViewCounts {
    std::uint64_t samples = 0;
    std::uint64_t dropped = 0;  // samples that were not finite
};

// Fills every tile of the film; irradiance_at is called by many threads at once. Reports stage progress. Throws
// Cancelled between tiles.
ViewCounts render_view(const View& view, const IrradianceAt& irradiance_at, Film& film, Control& control);

}  // namespace gg
