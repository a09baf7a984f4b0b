#include "radiosity/sky_balance.h"

#include <algorithm>

#include "transport/sky_cell.h"

namespace gg {

float hemisphere_rays_into(float solid_angle, std::uint32_t rays, Vec3 normal, Vec3 direction) {
    return static_cast<float>(rays) * std::max(0.0F, dot(normal, direction)) / kPi * solid_angle;
}

float hemisphere_share(const Hierarchy& hierarchy, const Sources& sources, SkyRays rays, Vec3 normal, Vec3 direction) {
    const SkyCell finest = finest_cell_at(direction);
    const Sources::Choice cell =
        sources.find(kSkySources, [&](NodeId source) { return contains(sky_cell_of(hierarchy[source]), finest); });
    if (cell.source == kNone) {
        return 1;
    }
    const float guided = cell.chance * static_cast<float>(rays.guided);
    const float own = hemisphere_rays_into(hierarchy[cell.source].area, rays.hemisphere, normal, direction);
    return own / std::max(own + guided, 1e-30F);
}

}  // namespace gg
