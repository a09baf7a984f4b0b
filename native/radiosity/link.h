// A link: the light that one node sends to another.
#pragma once

#include <cstdint>
#include <vector>

#include "core/vec.h"
#include "radiosity/hierarchy.h"

namespace gg {

// Irradiance [W/m2] that arrives: B form_factor visibility for a sender with one radiosity B; a cluster that is not
// `near` has pi J(w) in place of B, J its intensity [W/sr] in direction w towards the receiver. At an element the
// receiver's cosine is in the form factor; at a cluster it is not, the form factor is a solid angle over pi; a `near`
// link gives every face the same.
struct Link {
    NodeId receiver = 0;
    NodeId sender = 0;
    // At a cluster, and of a `near` link: mean of the unit directions to the sender, shorter than 1 as far as they spread.
    // Else, at an element: the form factor at its corners as shares of form_factor, which is their mean.
    Vec3 shape{0.0F};
    float form_factor = 0;      // unoccluded; times m2 for clusters that are not near: form_factor has unit 1/m2
    float visibility = 0;       // 0..1
    // Errors of form_factor * visibility, same unit: of its course over the receiver, which the other links of the
    // receiver make up for in part, and of its level, which nothing makes up for.
    float shape_error = 0;
    float level_error = 0;
    float nearest_occluder = 0;   // m from the receiver, 0 when nothing was hit
    float farthest_occluder = 0;
    bool near = false;          // found by rays from the receiver's faces: sender and receiver touch, or are one
};

}  // namespace gg
