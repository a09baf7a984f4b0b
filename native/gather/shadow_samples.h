// How many points of a sender its shadows need where they are looked at [Scheel et al. 2002, section 5.3].
#pragma once

#include "core/vec.h"
#include "gather/receiver.h"
#include "radiosity/hierarchy.h"
#include "scene/scene.h"

namespace gg {

// Largest width [m] of a sender seen along unit `direction`. Of a distant lamp: its angular diameter [rad].
[[nodiscard]] float sender_width(const Scene& scene, const Node& sender, Vec3 direction);

// A sender's shadow on a site's receivers.
struct Shadow {
    float width = 0;     // of the sender, as above
    float distance = 0;  // m, to the sender; infinity: distant lamp
    float occluder = 0;  // m, to what is between, as of CutSender; 0: unknown
    float cosine = 1;    // of the sender's direction to the surface that it falls on
    float pixel = 0;     // side of a pixel there, m
    float step = 0;      // radiosity that the sender takes away in full shadow, W/m2
};

// direction: unit, to the sender. irradiance: that it brings if nothing is in the way, on a plane that faces it,
// luminance [W/m2]. occluder: as above.
[[nodiscard]] Shadow shadow_on(const ReceiverMeans& receivers, const Hierarchy& hierarchy, NodeId sender,
                               Vec3 direction, float irradiance, float occluder);

// Every point of the sender is a step of the penumbra. So many make them far narrower than a pixel: more show nothing.
// Infinite where the width of the penumbra is not known.
[[nodiscard]] float steps_in_pixels(const Shadow& shadow);

// So many that steps are either no higher than `threshold` [W/m2] or that narrow, but never very few or many.
[[nodiscard]] float shadow_samples(const Shadow& shadow, float threshold);

}  // namespace gg
