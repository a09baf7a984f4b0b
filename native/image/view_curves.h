// Curves that pixels go through before they are shown, as users draw them over a picture.
#pragma once

#include <array>
#include <vector>

#include "core/vec.h"

namespace gg {

struct ViewCurves {
    struct Channel {
        std::vector<float> values;  // at even steps from `lower` to `upper`, at least two; linear in between
        float slope_below = 0, slope_above = 0;  // beyond these
        float black = 0, white = 1;              // of the pixel: 0 and 1 for the curve
    };

    std::array<Channel, 3> channels;  // red, green, blue
    float lower = 0, upper = 1;       // lower < upper

    [[nodiscard]] Rgb operator()(Rgb pixel) const;
};

}  // namespace gg
