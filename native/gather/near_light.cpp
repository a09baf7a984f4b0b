#include "gather/near_light.h"

#include "core/random.h"
#include "transport/sky_cell.h"

namespace gg {

NearLight::NearLight(const Solution& solution, const RayTracer& tracer)
    : solution_(solution), tracer_(tracer), marks_(hierarchy_of(solution).nodes().size()) {
    const Sequence4 sequence(0x6e656172);
    for (std::uint32_t i = 0; i < 2 * kNearDirections; ++i) {
        directions_.push_back(square_to_sphere(sequence(i, 0), sequence(i, 1)));
    }
}

void NearLight::trace(std::span<const NearOrigin> origins) {
    found_.clear();
    rays_.clear();
    std::size_t next = 0;
    for (const Vec3 direction : directions_) {
        for (std::size_t tried = 0; tried < origins.size(); ++tried) {
            const NearOrigin& origin = origins[next++ % origins.size()];
            if (dot(direction, origin.normal) > 0) {
                rays_.push_back({origin.position, direction, 0, kInfinity});
                break;
            }
        }
    }
    hits_.resize(rays_.size());
    tracer_.closest_hits(rays_, hits_, RayMask::kLight, Coherence::kIncoherent);
    const Hierarchy& hierarchy = hierarchy_of(solution_);
    for (std::size_t i = 0; i < rays_.size(); ++i) {
        const Hit& hit = hits_[i];
        if (hit.missed()) {
            continue;
        }
        const bool back = dot(world_area_vector(hierarchy.scene(), hit.instance, hit.triangle), rays_[i].direction) > 0;
        const NodeId place =
            place_at(solution_, hit.instance, hit.triangle, back, rays_[i].origin + hit.distance * rays_[i].direction);
        if (place != kNone) {
            const Rgb radiosity = is_cluster(hierarchy[place])
                                      ? face_radiosity(solution_, hit.instance, hit.triangle, back)
                                      : radiosity_of(solution_, place);
            found_.push_back({rays_[i].direction, 2.0F / kNearDirections * radiosity, place});
        }
    }
}

void NearLight::mark(std::span<const NodeId> clusters) {
    ++stamp_;
    for (const NodeId cluster : clusters) {
        marks_[cluster] = stamp_;
    }
}

bool NearLight::is_marked(NodeId place) const {
    const Hierarchy& hierarchy = hierarchy_of(solution_);
    NodeId id = place;
    while (id != kNone && marks_[id] != stamp_) {
        id = hierarchy[id].parent;
    }
    return id != kNone;
}

}  // namespace gg
