// A site: a place where the illumination is understood. It holds a complete model of the light there.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"
#include "gather/direction_table.h"
#include "gather/node_order.h"
#include "gather/sky_leaves.h"
#include "gather/surroundings.h"
#include "radiosity/solution.h"

namespace gg {

// A sender that has to be looked at anew at every point near the site, or a part of what it brings has.
struct SiteSender {
    NodeId sender = kNone;
    bool resample_form_factor = false, resample_visibility = false;
    float samples = 0;     // for its visibility
    float visibility = 0;  // 0..1 at the site
    Rgb irradiance{0.0F};  // unoccluded, on a plane that faces `direction` [W/m2]
    Vec3 direction{0.0F};  // unit, to the sender
    bool soft = false;     // its light belongs to PointLight::soft
};

// A sender that needs no closer look: on normal n it brings max(0, n.direction) * irradiance.
struct Beam {
    Vec3 direction{0.0F};  // unit
    Rgb irradiance{0.0F};  // W/m2
};

struct Site {
    std::vector<SiteSender> senders;  // to be resampled, in ascending order
    std::vector<RankRange> apart;     // surfaces among senders and beams, in ascending order
    std::vector<SkyLeaf> leaves;      // of the sky, to be resampled, in ascending order
    std::vector<Beam> beams;          // other senders that count
    DirectionTable table;             // what all other surfaces and the rest of the sky bring
    Reach reach;                      // surfaces closer than that are looked for anew
    TableCellSet near_cells;          // in the directions in which there are any
    TableCellSet close_cells;         // of these, those that take four rays

    [[nodiscard]] std::size_t bytes() const {
        return sizeof(Site) + senders.capacity() * sizeof(SiteSender) + apart.capacity() * sizeof(RankRange) +
               leaves.capacity() * sizeof(SkyLeaf) + beams.capacity() * sizeof(Beam);
    }
};

[[nodiscard]] inline Rgb light_of(std::span<const Beam> beams, Vec3 normal) {
    Rgb sum(0.0F);
    for (const Beam& beam : beams) {
        sum += std::max(0.0F, dot(normal, beam.direction)) * beam.irradiance;
    }
    return sum;
}

}  // namespace gg
