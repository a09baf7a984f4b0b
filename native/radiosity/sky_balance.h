// The sky by rays of two kinds, each where the other is not likely to go: what one brings is shared out by how many of
// both are expected in a direction, the balance heuristic [Veach and Guibas 1995].
#pragma once

#include <cstdint>

#include "radiosity/source_guide.h"

namespace gg {

// From one place.
struct SkyRays {
    std::uint32_t hemisphere = 0, guided = 0;
};

// Expected rays, of so many into the hemisphere by the cosine, into a small solid angle [sr] there.
[[nodiscard]] float hemisphere_rays_into(float solid_angle, std::uint32_t rays, Vec3 normal, Vec3 direction);

// What counts of the sky that a ray of the hemisphere meets in a direction, 0..1: all of it where no guided ray goes.
[[nodiscard]] float hemisphere_share(const Hierarchy& hierarchy, const Sources& sources, SkyRays rays, Vec3 normal,
                                     Vec3 direction);

}  // namespace gg
