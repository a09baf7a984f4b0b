// Size of soft shadows.
#pragma once

#include "core/vec.h"

namespace gg {

// Width [m] of the penumbra on a plane perpendicular to the ray, by similar triangles: w = d_s a / (D - a), with the
// sender's width d_s seen from the receiver, the receiver's distance D to the sender and a to the occluder, 0 <= a.
// Infinite when the occluder touches the sender (a >= D). A sender at infinity has no width: there it is its angular
// width [rad] times a.
[[nodiscard]] inline float penumbra_width(float sender_width, float distance, float occluder_distance) {
    const float sender_to_occluder = distance - occluder_distance;
    return sender_to_occluder > 0 ? sender_width * occluder_distance / sender_to_occluder : kInfinity;
}

}  // namespace gg
