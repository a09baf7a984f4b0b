// A site: a place where the illumination is understood. It holds a complete model of the light there, sender by sender.
#pragma once

#include <cstdint>
#include <vector>

#include "core/vec.h"
#include "radiosity/solution.h"
#include "transport/directional_form.h"

namespace gg {

// A sender that has to be looked at anew at every point near the site, or a part of what it brings has.
struct SiteSender {
    NodeId sender = kNone;
    bool resample_form_factor = false, resample_visibility = false;
    float samples = 0;          // for its visibility
    float visibility = 0;       // 0..1 at the site
    Rgb irradiance{0.0F};       // unoccluded, on a plane that faces `direction` [W/m2]
    Vec3 direction{0.0F};       // unit, to the sender
};

struct Site {
    std::vector<SiteSender> senders;  // to be resampled, in ascending order
    DirectionalForm interpolated;     // what all others bring
};

}  // namespace gg
