#include "radiosity/link_estimate.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/random.h"
#include "radiosity/arrival.h"
#include "radiosity/face_sampling.h"
#include "radiosity/near_link.h"
#include "trace/surface_point.h"
#include "transport/emitter_sampling.h"
#include "transport/form_factor.h"

namespace gg {

namespace {

constexpr int kPoints = 4;  // of an element, at which form factors are evaluated
constexpr int kClusterPoints = 16;

// Corners of quarter k, numbered as in hierarchy.cpp.
std::array<Vec3, 3> quarter_of(const std::array<Vec3, 3>& c, int k) {
    if (k == 3) {
        return {0.5F * (c[1] + c[2]), 0.5F * (c[2] + c[0]), 0.5F * (c[0] + c[1])};
    }
    std::array<Vec3, 3> quarter;
    for (int i = 0; i < 3; ++i) {
        quarter[i] = 0.5F * (c[i] + c[k]);
    }
    return quarter;
}

Vec3 centroid(const std::array<Vec3, 3>& c) {
    return (c[0] + c[1] + c[2]) / 3.0F;
}

// Stratified in the order of the tree, which is that of places. Too few would bias the solution: links whose sampled
// form factor is too small are the ones that pass for good.
std::array<Vec3, kClusterPoints> cluster_points(const Hierarchy& hierarchy, const Node& node, SampleSet samples) {
    const Sequence4 sequence(hash64(node.stable_id, static_cast<std::uint64_t>(samples)));
    std::array<Vec3, kClusterPoints> points;
    for (std::uint32_t k = 0; k < kClusterPoints; ++k) {
        const float u = (static_cast<float>(k) + sequence(k, 0)) / kClusterPoints;
        points[k] = sample_face(hierarchy, node, u, sequence(k, 1), sequence(k, 2)).position;
    }
    return points;
}

enum class SpotEdge { kInside, kCrosses, kOutside };

// Where a receiver lies to the edge of a spot's cone.
SpotEdge spot_edge(const Node& receiver, const Lamp& lamp) {
    if (!lamp.is_spot) {
        return SpotEdge::kInside;
    }
    const Vec3 to_receiver = receiver.center - lamp.position;
    const float distance = length(to_receiver);
    const float size = receiver.radius + lamp.radius;
    if (distance <= size) {
        return SpotEdge::kCrosses;
    }
    const float angle = std::acos(std::clamp(dot(to_receiver, lamp.direction) / distance, -1.0F, 1.0F));
    const float edge = std::acos(std::clamp(lamp.spot_cos, -1.0F, 1.0F));
    const float half_width = std::asin(size / distance);
    return angle - half_width > edge   ? SpotEdge::kOutside
           : angle + half_width < edge ? SpotEdge::kInside
                                       : SpotEdge::kCrosses;
}

// A point of quarter k (numbered as in hierarchy.cpp) of an element.
Vec3 point_in_quarter(const Node& node, int k, float u, float v) {
    const Vec3 w = square_to_triangle(u, v);
    const Vec3* c = node.corner;
    const Vec3 inner = w.x * c[0] + w.y * c[1] + w.z * c[2];
    return k == 3 ? 0.5F * (c[0] + c[1] + c[2] - inner) : 0.5F * (c[k] + inner);
}

bool all_behind(const Node& node, const Node& element) {
    if (node.kind == NodeKind::kElement) {
        return !in_front(node.corner[0], element) && !in_front(node.corner[1], element) &&
               !in_front(node.corner[2], element);
    }
    const Vec3 farthest(element.normal.x > 0 ? node.corner[1].x : node.corner[0].x,
                        element.normal.y > 0 ? node.corner[1].y : node.corner[0].y,
                        element.normal.z > 0 ? node.corner[1].z : node.corner[0].z);
    return !in_front(farthest, element);
}

bool behind_lamp(const Node& receiver, const Lamp& lamp) {
    if (lamp.shape != LampShape::kRectangle && lamp.shape != LampShape::kEllipse) {
        return false;
    }
    return dot(receiver.center - lamp.position, lamp.direction) < -receiver.radius;
}

// Mean form factors of an element's quarters, at their centroids: the same points for every sender, so that the form
// factors of senders that together cover a hemisphere sum to exactly one. Next to the sender form factors are steep,
// and one point misses much of what falls near a common edge: there every quarter has four.
std::array<float, kPoints> quarter_form_factors(const Hierarchy& hierarchy, const Node& receiver, const Node& sender) {
    std::array<float, kPoints> factors{};
    if (sender.kind == NodeKind::kSky) {  // the same everywhere
        factors.fill(form_factor_at(hierarchy, receiver, sender, receiver.center));
        return factors;
    }
    const std::array<Vec3, 3> whole{receiver.corner[0], receiver.corner[1], receiver.corner[2]};
    const bool steep = sender.kind == NodeKind::kElement &&
                       length(receiver.center - sender.center) < 1.5F * (receiver.radius + sender.radius);
    for (int k = 0; k < kPoints; ++k) {
        const std::array<Vec3, 3> quarter = quarter_of(whole, k);
        if (!steep) {
            factors[k] = form_factor_at(hierarchy, receiver, sender, centroid(quarter));
            continue;
        }
        for (int i = 0; i < kPoints; ++i) {
            factors[k] += 0.25F * form_factor_at(hierarchy, receiver, sender, centroid(quarter_of(quarter, i)));
        }
    }
    return factors;
}

// The linear function over an element that fits its values at the centroids of the quarters best. Returns its error.
float set_linear_shape(const std::array<float, kPoints>& f, Link& link) {
    const float outer = (f[0] + f[1] + f[2]) / 3;
    const float mean = 0.25F * (3 * outer + f[3]);
    link.shape = Vec3(1.0F);
    if (mean > 0) {
        // The centroid of quarter k lies half as far from the middle as corner k.
        const Vec3 corner = glm::max(mean + 2.0F * (Vec3(f[0], f[1], f[2]) - outer), Vec3(0.0F));
        link.shape = corner * (3 / std::max(corner.x + corner.y + corner.z, 1e-30F));
    }
    const auto [least, most] = std::minmax_element(f.begin(), f.end());
    constexpr float kUnseen = 0.1F;  // share of the whole variation that may hide between four points
    return std::max(std::abs(f[3] - outer), kUnseen * (*most - *least));
}

// Between the middles, m; infinite for the sky and distant lamps.
float distance_to(const Hierarchy& hierarchy, const Node& receiver, const Node& sender) {
    const bool infinite =
        sender.kind == NodeKind::kSky ||
        (sender.kind == NodeKind::kLamp && hierarchy.scene().lamps[sender.source].shape == LampShape::kDistant);
    return infinite ? kInfinity : length(receiver.center - sender.center);
}

// Fills form factor and direction at a cluster; returns how much both vary over the receiver.
float set_cluster_form_factor(const Hierarchy& hierarchy, const Node& receiver, const Node& sender, SampleSet samples,
                              Link& link) {
    Vec3 sum(0.0F);
    float least = kInfinity, most = 0, total = 0, solid_angle = 0;
    for (const Vec3 x : cluster_points(hierarchy, receiver, samples)) {
        const Arrival light = arrival(hierarchy, sender, x);
        sum += light.factor * light.direction;
        total += light.factor;
        solid_angle += light.solid_angle;
        least = std::min(least, light.factor);
        most = std::max(most, light.factor);
    }
    link.form_factor = solid_angle / kClusterPoints;
    link.shape = solid_angle > 0 ? sum / solid_angle : Vec3(0.0F);
    const float sampled = 0.5F * (most - least) + (total - length(sum)) / kClusterPoints;
    // Few points may all lie on one part of the receiver: direction and distance to the sender vary by its size.
    const float size = std::min(1.0F, receiver.radius / std::max(distance_to(hierarchy, receiver, sender), 1e-30F));
    return std::max(sampled, size * link.form_factor);
}

struct ShadowRays {
    std::array<Ray, kMaxRays> rays;
    std::array<float, kMaxRays> weights{};
    std::array<float, kMaxRays> lengths{};  // m
    std::array<std::uint8_t, kMaxRays> quarters{};
    std::size_t count = 0;
    bool sender_shines = false;  // some point of the sender faces some point of the receiver, if not the reverse
};

// Adds the ray from a receiver's face to a point or direction of the sender, unless they do not face each other.
void add_pair(const Hierarchy& hierarchy, const FacePoint& x, const Node& sender, Vec3 uvw, int quarter,
              ShadowRays& out) {
    const float u = uvw.x, v = uvw.y, w = uvw.z;
    Vec3 target(0.0F), target_normal(0.0F);
    float sender_weight = 1;
    bool infinite = false;
    if (sender.kind == NodeKind::kLamp) {
        const LampSample sample = sample_lamp(hierarchy.scene().lamps[sender.source], x.position, v, w);
        sender_weight = luminance(sample.normal_irradiance);
        infinite = std::isinf(sample.distance);
        target = infinite ? x.position + sample.direction : sample.point;
    } else if (sender.kind == NodeKind::kSky) {
        infinite = true;
        target = x.position + cell_direction(sky_cell_of(sender), v, w);
    } else {
        const FacePoint y = sample_face(hierarchy, sender, u, v, w);
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
    out.quarters[out.count] = static_cast<std::uint8_t>(quarter);
    ++out.count;
}

// Where the occluders of a partly visible sender are, seen from the receiver.
void find_occluders(const RayTracer& tracer, const ShadowRays& pairs, const std::array<std::uint8_t, kMaxRays>& blocked,
                    Link& link) {
    float nearest = kInfinity;
    for (std::size_t i = 0; i < pairs.count; ++i) {
        if (!blocked[i]) {
            continue;
        }
        const Ray& ray = pairs.rays[i];
        const Hit first = tracer.closest_hit(ray, RayMask::kLight);
        if (first.missed()) {
            continue;
        }
        nearest = std::min(nearest, first.distance * pairs.lengths[i]);
        float last = first.distance;
        if (!std::isinf(ray.far)) {
            const Hit reverse =
                tracer.closest_hit({ray.origin + ray.direction, -ray.direction, 0, ray.far}, RayMask::kLight);
            last = reverse.missed() ? last : 1 - reverse.distance;
        }
        link.farthest_occluder = std::max(link.farthest_occluder, last * pairs.lengths[i]);
    }
    link.nearest_occluder = std::isinf(nearest) ? 0 : nearest;
}

// What the shadow rays of a link saw, for the whole receiver and for the quarters of an element.
struct Seen {
    float visibility = 0;
    std::array<float, kPoints> quarters{};
    float sampling_error = 0;
};

ShadowRays make_shadow_rays(const Hierarchy& hierarchy, const Node& receiver, const Node& sender, int count,
                            SampleSet samples) {
    const Sequence6 sequence = pair_sequence(receiver, sender, samples);
    ShadowRays pairs;
    for (int k = 0; k < count; ++k) {
        const auto i = static_cast<std::uint32_t>(k);
        if (receiver.kind == NodeKind::kElement) {
            // Quarters share the points on the sender: what differs between them is then more than noise.
            const std::uint32_t j = i / kPoints;
            const Vec3 x = point_in_quarter(receiver, k % kPoints, sequence(i, 0), sequence(i, 1));
            add_pair(hierarchy, {x, receiver.normal, 1, 0}, sender, {sequence(j, 5), sequence(j, 3), sequence(j, 4)},
                     k % kPoints, pairs);
        } else {
            add_pair(hierarchy, sample_face(hierarchy, receiver, sequence(i, 2), sequence(i, 0), sequence(i, 1)),
                     sender, {sequence(i, 5), sequence(i, 3), sequence(i, 4)}, 0, pairs);
        }
    }
    return pairs;
}

// Sets the link's occluders.
Seen trace_shadow_rays(const RayTracer& tracer, const ShadowRays& pairs, int count, Link& link) {
    std::array<std::uint8_t, kMaxRays> blocked{};
    tracer.occluded(std::span<const Ray>(pairs.rays.data(), pairs.count),
                    std::span<std::uint8_t>(blocked.data(), pairs.count), RayMask::kLight, Coherence::kIncoherent);
    std::array<float, kPoints> seen{}, total{};
    for (std::size_t i = 0; i < pairs.count; ++i) {
        total[pairs.quarters[i]] += pairs.weights[i];
        seen[pairs.quarters[i]] += blocked[i] ? 0.0F : pairs.weights[i];
    }
    const float all_seen = seen[0] + seen[1] + seen[2] + seen[3];
    const float all = total[0] + total[1] + total[2] + total[3];
    Seen result;
    result.visibility = all > 0 ? all_seen / all : 0.0F;
    for (int k = 0; k < kPoints; ++k) {
        result.quarters[k] = total[k] > 0 ? seen[k] / total[k] : result.visibility;
    }
    const auto n = static_cast<float>(count);
    const bool mixed = result.visibility > 0 && result.visibility < 1;
    if (mixed) {
        find_occluders(tracer, pairs, blocked, link);
        // Well-spread points converge faster than random ones; in two dimensions about as n^-3/4.
        result.sampling_error = std::sqrt(result.visibility * (1 - result.visibility)) / std::pow(n, 0.75F);
    } else {
        // Pairs that do not face each other need no ray to be believed.
        const float facing = static_cast<float>(std::max<std::size_t>(pairs.count, 1)) / n;
        result.sampling_error = facing * kUnproven / (n + 2);
    }
    return result;
}

// Share by which the light of a spread-out cluster differs from that of its middle: second order in size over distance.
float far_field_error(const Node& receiver, const Node& sender) {
    const float distance = length(receiver.center - sender.center);
    const float ratio = sender.radius / std::max(distance, sender.radius);
    return 0.5F * ratio * ratio;
}

}  // namespace

bool never_exchange(const Hierarchy& hierarchy, const Node& receiver, const Node& sender) {
    if (receiver.kind == NodeKind::kElement && is_surface(sender) && all_behind(sender, receiver)) {
        return true;
    }
    if (sender.kind == NodeKind::kElement && all_behind(receiver, sender)) {
        return true;
    }
    if (sender.kind != NodeKind::kLamp) {
        return false;
    }
    const Lamp& lamp = hierarchy.scene().lamps[sender.source];
    return behind_lamp(receiver, lamp) || spot_edge(receiver, lamp) == SpotEdge::kOutside;
}

bool separated(const Node& receiver, const Node& sender) {
    return length(receiver.center - sender.center) > receiver.radius + sender.radius;
}

float form_factor_bound(const Hierarchy& hierarchy, const Node& receiver, const Node& sender) {
    if (sender.kind == NodeKind::kSky) {
        return sender.area / kPi;
    }
    if (sender.kind == NodeKind::kLamp) {
        const Lamp& lamp = hierarchy.scene().lamps[sender.source];
        if (lamp.shape == LampShape::kDistant) {
            return 1;
        }
        const float gap = length(receiver.center - sender.center) - receiver.radius;
        if (lamp.shape == LampShape::kPoint) {
            return 1 / std::max(gap * gap, 1e-12F);
        }
        return gap > sender.radius ? (sender.radius / gap) * (sender.radius / gap) : 1.0F;
    }
    const float gap = length(receiver.center - sender.center) - receiver.radius;
    if (gap <= sender.radius) {
        return 1;
    }
    const float shown = sender.kind == NodeKind::kElement ? sender.area : 0.25F * sender.area;
    const float sphere = (sender.radius / gap) * (sender.radius / gap);
    const float reach = gap - sender.radius;
    return std::min(sphere, shown / (kPi * reach * reach + shown));
}

Link estimate_link(const Hierarchy& hierarchy, const RayTracer& tracer, NodeId receiver, NodeId sender, int rays,
                   SampleSet samples, NearHits* hits) {
    const Node& to = hierarchy[receiver];
    const Node& from = hierarchy[sender];
    const int count = std::clamp(rays, 4, kMaxRays);
    Link link;
    link.receiver = receiver;
    link.sender = sender;
    if (is_cluster(from) && !separated(to, from)) {
        estimate_near(hierarchy, tracer, to, from, std::max(count, 16), samples, link, hits);
        return link;
    }
    const ShadowRays pairs = make_shadow_rays(hierarchy, to, from, count, samples);
    const Seen seen = trace_shadow_rays(tracer, pairs, count, link);
    if (to.kind == NodeKind::kElement) {
        const std::array<float, kPoints> unoccluded = quarter_form_factors(hierarchy, to, from);
        std::array<float, kPoints> arriving{};
        for (int k = 0; k < kPoints; ++k) {
            arriving[k] = unoccluded[k] * seen.quarters[k];
        }
        link.form_factor = 0.25F * (unoccluded[0] + unoccluded[1] + unoccluded[2] + unoccluded[3]);
        const float mean = 0.25F * (arriving[0] + arriving[1] + arriving[2] + arriving[3]);
        link.visibility = link.form_factor > 0 ? mean / link.form_factor : 0.0F;
        link.shape_error = set_linear_shape(unoccluded, link) * link.visibility;
        const float arriving_error = set_linear_shape(arriving, link);
        link.level_error = link.form_factor * seen.sampling_error;
        if (link.visibility < 1) {
            link.level_error += arriving_error;
        }
    } else {
        constexpr float kShadowEdge = 0.25F;  // of a half-seen sender's light may fall on the wrong faces
        // Where the points of a cluster all face away, nothing is known to be in the way of faces that do not.
        const bool unknown = pairs.count == 0 && pairs.sender_shines;
        link.visibility = unknown ? 1.0F : seen.visibility;
        const float variation = set_cluster_form_factor(hierarchy, to, from, samples, link);
        const float edge = kShadowEdge * std::sqrt(seen.visibility * (1 - seen.visibility));
        constexpr float kMadeUpFor = 0.5F;  // share of the variation that other senders make up for, see Link
        link.shape_error = kMadeUpFor * variation * seen.visibility;
        constexpr float kFormError = 0.033F;  // rms of the quadratic form that a cluster receives, directional_form.h
        link.level_error = link.form_factor * (seen.sampling_error + edge + kFormError * seen.visibility) +
                           (1 - kMadeUpFor) * variation * seen.visibility;
    }
    if (from.kind == NodeKind::kLamp && spot_edge(to, hierarchy.scene().lamps[from.source]) == SpotEdge::kCrosses) {
        constexpr float kUnseenEdge = 0.25F;  // few points may all lie on one side of the edge
        link.level_error += kUnseenEdge * form_factor_bound(hierarchy, to, from);
    }
    if (is_cluster(from)) {
        link.level_error += far_field_error(to, from) * link.form_factor * link.visibility;
    }
    return link;
}

}  // namespace gg
