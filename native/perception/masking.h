// Visual masking: what pattern hides which difference [Ramasubramanian et al. 1999; Daly 1993].
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "perception/viewing.h"

namespace gg {

class Control;

// By which factor a contrast raises the threshold of others of its frequency, >= 1. visible: the contrast in units of
// the least visible one, >= 0.
[[nodiscard]] float contrast_elevation(float visible);

// What an eye that looks at a picture is used to and misses, per pixel, row by row.
struct MaskingMap {
    static constexpr float kMost = 10;  // elevation

    std::uint32_t width = 0, height = 0;
    std::vector<float> adaptation;  // mean luminance of about a degree around, cd/m2
    std::vector<float> elevation;   // by which factor the threshold of a difference is raised, 1..kMost
};

// Only patterns of 16 cycles/degree and more count, or of the finest octave if it is coarser.
// luminance: of a picture on a display [cd/m2], row by row, width * height, finite. Throws Cancelled.
[[nodiscard]] MaskingMap masking_map(std::uint32_t width, std::uint32_t height, std::vector<float> luminance,
                                     const Viewing& viewing, const Control& control);

}  // namespace gg
