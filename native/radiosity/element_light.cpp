#include "radiosity/element_light.h"

#include "core/random.h"
#include "trace/surface_point.h"

namespace gg {

namespace {

constexpr float kInset = 0.05F;  // of points towards the centre
constexpr std::uint64_t kSeed = 0x73657061;

}  // namespace

ElementLight::Points ElementLight::points_of(const Node& element) {
    const auto& corner = element.corner;
    const Vec3 centre = (corner[0] + corner[1] + corner[2]) / 3.0F;
    Points points;
    for (int k = 0; k < 3; ++k) {
        points[k] = glm::mix(corner[k], centre, kInset);
        points[3 + k] = glm::mix(0.5F * (corner[(k + 1) % 3] + corner[(k + 2) % 3]), centre, kInset);
    }
    return points;
}

ElementLight::Values ElementLight::at(const Points& points, const Node& element) {
    const Sequence4 sequence(hash64(element.stable_id, kSeed));
    const Frame frame(element.normal);
    for (int k = 0; k < kDirections; ++k) {
        const Vec3 direction = frame.to_world(square_to_cosine_hemisphere(sequence(k, 0), sequence(k, 1)));
        for (int p = 0; p < kPoints; ++p) {
            rays_[kPoints * k + p] = {offset_origin(points[p], element.normal, element.radius), direction, 0,
                                      kInfinity};
        }
    }
    tracer_.closest_hits(rays_, hits_, RayMask::kLight, Coherence::kIncoherent);
    Values light{};
    for (int i = 0; i < kPoints * kDirections; ++i) {
        light[i % kPoints] += luminance(seen_.radiosity(rays_[i], hits_[i])) / kDirections;
    }
    return light;
}

}  // namespace gg
