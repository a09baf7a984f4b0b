#include "oracles/brute_visibility.h"

#include <cmath>
#include <optional>

#include "core/random.h"
#include "support/face_points.h"
#include "trace/surface_point.h"
#include "transport/emitter_sampling.h"

namespace gg::oracle {
namespace {

// Where a ray to the sender ends, and what it weighs beside the receiver's cosine.
struct Target {
    Vec3 direction{0.0F};  // from the receiver; to the sender's point, or unit when it is infinitely far
    Vec3 normal{0.0F};     // of a surface sender
    double weight = 0;
    bool infinite = false;
};

Target make_target(const Hierarchy& hierarchy, const Node& sender, const test::FacePoints* points, Vec3 x, float u,
                   float v, float w) {
    if (sender.kind == NodeKind::kSky) {
        return {cell_direction(sky_cell_of(sender), u, v), Vec3(0.0F), 1, true};
    }
    if (sender.kind == NodeKind::kLamp) {
        const LampSample sample = sample_lamp(hierarchy.scene().lamps[sender.source], x, u, v);
        const bool infinite = std::isinf(sample.distance);
        return {infinite ? sample.direction : sample.point - x, Vec3(0.0F), luminance(sample.normal_irradiance),
                infinite};
    }
    const test::EvenPoint y = points->sample(w, u, v);
    const Vec3 direction = y.position - x;
    const double distance = length(direction);
    const double weight = std::max(0.0F, -dot(direction, y.normal)) / (distance * distance * distance);
    return {direction, y.normal, weight, false};
}

}  // namespace

double counted_visibility(const Hierarchy& hierarchy, const RayTracer& tracer, NodeId receiver, NodeId sender,
                          std::uint32_t pairs, std::uint64_t seed) {
    const Node& from = hierarchy[sender];
    const test::FacePoints at_receiver(hierarchy, hierarchy[receiver]);
    std::optional<test::FacePoints> at_sender;
    if (is_surface(from)) {
        at_sender.emplace(hierarchy, from);
    }
    double all = 0, seen = 0;
    for (std::uint32_t i = 0; i < pairs; ++i) {
        const auto number = [&](std::uint64_t dimension) { return unit_float(hash64(hash64(seed, i), dimension)); };
        const test::EvenPoint x = at_receiver.sample(number(0), number(1), number(2));
        const Target target = make_target(hierarchy, from, at_sender ? &*at_sender : nullptr, x.position, number(3),
                                          number(4), number(5));
        const float distance = length(target.direction);
        const double weight = target.weight * std::max(0.0F, dot(x.normal, target.direction)) / distance;
        if (!(weight > 0)) {
            continue;
        }
        const Vec3 origin = offset_origin(x.position, x.normal, target.infinite ? 1.0F : distance);
        const Vec3 end = target.infinite ? origin + target.direction
                                         : offset_origin(x.position + target.direction, target.normal, distance);
        const float far = target.infinite ? kInfinity : 1 - 1e-5F;
        all += weight;
        seen += tracer.occluded({origin, end - origin, 0, far}, RayMask::kLight) ? 0 : weight;
    }
    return all > 0 ? seen / all : -1;
}

}  // namespace gg::oracle
