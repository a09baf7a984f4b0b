#include "radiosity/shadow_rays.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "radiosity/face_sampling.h"
#include "trace/surface_point.h"
#include "transport/emitter_sampling.h"

namespace gg {

namespace {

constexpr float kFar = 4;  // half diagonals of a lamp from which its samples are even by area

// Adds the ray from a receiver's face to a point or direction of the sender, unless they do not face each other.
void add_pair(const Hierarchy& hierarchy, const FacePoint& x, const Node& sender, Vec3 uvw, int quarter,
              ShadowRays& out) {
    const float u = uvw.x, v = uvw.y, w = uvw.z;
    Vec3 target(0.0F), target_normal(0.0F);
    float sender_weight = 1;
    bool infinite = false;
    if (sender.kind == NodeKind::kLamp) {
        const LampSample sample = sample_lamp(hierarchy.scene().lamps[sender.source], x.position, v, w, kFar);
        sender_weight = luminance(sample.normal_irradiance);
        infinite = std::isinf(sample.distance);
        target = infinite ? x.position + sample.direction : sample.point;
    } else if (sender.kind == NodeKind::kSky) {
        infinite = true;
        target = x.position + cell_direction(sky_cell_of(sender), v, w);
    } else {
        const FacePoint y = sample_face(hierarchy, sender, Spread::kByExposure, u, v, w);
        target = y.position;
        const FacingSide side = side_towards(y, x.position);
        target_normal = side.normal;
        const Vec3 d = x.position - target;
        const float squared = length_squared(d);
        const float cosine = dot(d, target_normal) / std::sqrt(std::max(squared, 1e-30F));
        sender_weight = side.chance * std::max(0.0F, cosine) / (squared + sender.area / (4 * kPi));
    }
    out.sender_shines |= sender_weight > 0;
    const auto [normal, chance] = side_towards(x, target);
    const Vec3 to_target = target - x.position;
    const float distance = length(to_target);
    const float weight = chance * sender_weight * std::max(0.0F, dot(normal, to_target)) / std::max(distance, 1e-30F);
    if (!(weight > 0)) {
        return;
    }
    const Vec3 origin = offset_origin(x.position, normal, infinite ? 1.0F : distance);
    const Vec3 end = infinite ? origin + to_target : offset_origin(target, target_normal, distance);
    out.rays[out.count] = {origin, end - origin, 0.0F, infinite ? kInfinity : 1.0F - 1e-5F};
    out.weights[out.count] = weight;
    out.lengths[out.count] = distance;
    out.targets[out.count] = target;
    out.quarters[out.count] = static_cast<std::uint8_t>(quarter);
    ++out.count;
}

}  // namespace

ShadowRays make_shadow_rays(const Hierarchy& hierarchy, const Node& receiver, const Node& sender, int count,
                            SampleSet samples) {
    const Sequence6 sequence = pair_sequence(receiver, sender, samples);
    ShadowRays pairs;
    for (int k = 0; k < count; ++k) {
        const auto i = static_cast<std::uint32_t>(k);
        if (receiver.kind == NodeKind::kElement) {
            // Quarters share the points on the sender: what differs between them is then more than noise.
            const std::uint32_t j = i / kQuarters;
            const int quarter = k % kQuarters;
            const Vec3 weights = square_to_triangle(sequence(i, 0), sequence(i, 1));
            const auto corners = quarter_of(receiver.corner, quarter);
            const Vec3 x = weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2];
            add_pair(hierarchy, {x, receiver.normal, 1, 0}, sender, {sequence(j, 5), sequence(j, 3), sequence(j, 4)},
                     quarter, pairs);
        } else {
            add_pair(hierarchy,
                     sample_face(hierarchy, receiver, Spread::kByArea, sequence(i, 2), sequence(i, 0), sequence(i, 1)),
                     sender, {sequence(i, 5), sequence(i, 3), sequence(i, 4)}, 0, pairs);
        }
    }
    return pairs;
}

Seen trace_shadow_rays(const RayTracer& tracer, const ShadowRays& pairs, int count, float reach) {
    Seen result;
    tracer.occluded(std::span<const Ray>(pairs.rays.data(), pairs.count),
                    std::span<std::uint8_t>(result.blocked.data(), pairs.count), RayMask::kLight,
                    Coherence::kIncoherent);
    std::array<float, kQuarters> seen{}, total{};
    float near = 0;
    for (std::size_t i = 0; i < pairs.count; ++i) {
        total[pairs.quarters[i]] += pairs.weights[i];
        seen[pairs.quarters[i]] += result.blocked[i] ? 0.0F : pairs.weights[i];
        near += result.blocked[i] || pairs.lengths[i] > reach ? 0.0F : pairs.weights[i];
    }
    const float all_seen = seen[0] + seen[1] + seen[2] + seen[3];
    const float all = total[0] + total[1] + total[2] + total[3];
    result.visibility = all > 0 ? all_seen / all : 0.0F;
    result.near_share = all_seen > 0 ? near / all_seen : 0.0F;
    for (int k = 0; k < kQuarters; ++k) {
        result.quarters[k] = total[k] > 0 ? seen[k] / total[k] : result.visibility;
    }
    const auto n = static_cast<float>(count);
    const bool mixed = result.visibility > 0 && result.visibility < 1;
    if (mixed) {
        // Well-spread points converge faster than random ones; in two dimensions about as n^-3/4.
        result.sampling_error = std::sqrt(result.visibility * (1 - result.visibility)) / std::pow(n, 0.75F);
    } else {
        // Pairs that do not face each other need no ray to be believed.
        const float facing = static_cast<float>(std::max<std::size_t>(pairs.count, 1)) / n;
        result.sampling_error = facing * kUnproven / (n + 2);
    }
    return result;
}

void find_occluders(const Hierarchy& hierarchy, const RayTracer& tracer, const ShadowRays& pairs, const Seen& seen,
                    Link& link) {
    constexpr int kEnough = 4;  // blocked rays that are followed
    float nearest = kInfinity;
    int followed = 0;
    for (std::size_t i = 0; i < pairs.count && followed < kEnough; ++i) {
        if (!seen.blocked[i]) {
            continue;
        }
        ++followed;
        Ray ray = pairs.rays[i];
        const Hit first = tracer.closest_hit(ray, RayMask::kLight);
        if (!first.missed()) {
            ray.far = std::min(ray.far, hierarchy.extent_from(ray.origin) / length(ray.direction));
            const float last = tracer.farthest_hit(ray, RayMask::kLight);
            nearest = std::min(nearest, first.distance * pairs.lengths[i]);
            link.farthest_occluder =
                std::max(link.farthest_occluder, std::max(last, first.distance) * pairs.lengths[i]);
        }
    }
    link.nearest_occluder = std::isinf(nearest) ? 0 : nearest;
}

}  // namespace gg
