// How a picture is shown and looked at.
#pragma once

namespace gg {

struct Viewing {
    float white = 100;             // luminance of the display's white, cd/m2
    float black = 0.2F;            // of its black, which is added to everything
    float pixels_per_degree = 40;  // of the visual field
};

}  // namespace gg
