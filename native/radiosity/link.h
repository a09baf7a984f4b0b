// A link: the light that one node sends to another.
#pragma once

#include <cstdint>
#include <vector>

#include "core/vec.h"
#include "radiosity/hierarchy.h"

namespace gg {

// Irradiance [W/m2] that arrives: B form_factor visibility brightness for a sender with one radiosity B; a cluster has
// pi J(w) in place of B, J its intensity [W/sr] in direction w towards the receiver. At an element the receiver's
// cosine is in the form factor; at a cluster it is not, the form factor is a solid angle over pi.
//
// Between clusters that touch or are one there is no such formula. They have a `near` link: rays from the receiver's
// faces that hit the sender, and bring the radiosity of what they hit.
struct Link {
    NodeId receiver = 0;
    NodeId sender = 0;
    // At a cluster: mean of the unit directions to the sender, shorter than 1 as far as they spread. At an element: the
    // form factor at its corners as shares of form_factor, which is their mean.
    Vec3 shape{0.0F};
    float form_factor = 0;  // unoccluded; times m2 for clusters; of near links: share of the rays that hit
    float visibility = 0;   // 0..1
    float brightness = 1;   // of what the receiver sees of the sender, over the sender's mean
    float near_share = 0;   // of what arrives: from closer than what the receiver's patches looked for
    // Errors of form_factor * visibility, same unit: of its course over the receiver, which the other links of the
    // receiver make up for in part, and of its level, which nothing makes up for.
    float shape_error = 0;
    float level_error = 0;
    float nearest_occluder = 0;  // m from the receiver, 0 when nothing was hit
    float farthest_occluder = 0;
    bool near = false;
    std::uint8_t ray_count = 0;  // of a near link: rays, of which hit_count hit the sender
    std::uint8_t hit_count = 0;
    std::uint32_t first_hit = 0;  // into NearHits
};

// A ray of a near link that hit the sender.
struct NearHit {
    std::uint32_t instance = 0, triangle = 0;
    NodeId leaf = kNone;  // what was hit, as far as the hierarchy is open; set by Lighting
    bool back = false;
    // Per unit of radiosity that this ray brings, what faces with normal n get more than others: lean . n.
    Vec3 lean{0.0F};
};

using NearHits = std::vector<NearHit>;

struct Links {
    std::vector<Link> all;
    NearHits hits;
};

}  // namespace gg
