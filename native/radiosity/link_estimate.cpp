#include "radiosity/link_estimate.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/random.h"
#include "radiosity/arrival.h"
#include "radiosity/face_sampling.h"
#include "radiosity/near_link.h"
#include "radiosity/quarter.h"
#include "radiosity/shadow_rays.h"
#include "transport/form_factor.h"

namespace gg {

namespace {

constexpr int kPoints = kQuarters;  // of an element, at which form factors are evaluated
constexpr int kClusterPoints = 16;
constexpr float kFarSmaller = 0.25F;  // area of a sender as a share of the receiver's

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
        points[k] = sample_face(hierarchy, node, Spread::kByArea, u, sequence(k, 1), sequence(k, 2)).position;
    }
    return points;
}

// Whether form factors between points of two elements differ by much.
bool are_close(const Node& a, const Node& b) {
    return length(a.center - b.center) < 1.5F * (a.radius + b.radius);
}

// The same by reciprocity, A_r F_rs = A_s F_sr, from points of a sender that is far smaller: it may lie so close that
// the receiver's few points all miss its light.
std::array<float, kPoints> quarter_form_factors_of_small(const Node& receiver, const Node& sender) {
    std::array<float, kPoints> factors{};
    for (int i = 0; i < kPoints; ++i) {
        const Vec3 y = centroid(quarter_of(sender.corner, i));
        if (!in_front(y, receiver)) {
            continue;
        }
        for (int k = 0; k < kPoints; ++k) {
            const std::array<Vec3, 3> c = quarter_of(receiver.corner, k);
            factors[k] += sender.area / receiver.area * point_to_triangle(y, sender.normal, c[0], c[1], c[2]);
        }
    }
    return factors;
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
    if (sender.kind == NodeKind::kElement && sender.area < kFarSmaller * receiver.area) {
        return quarter_form_factors_of_small(receiver, sender);
    }
    const bool steep = sender.kind == NodeKind::kElement && are_close(receiver, sender);
    for (int k = 0; k < kPoints; ++k) {
        const std::array<Vec3, 3> quarter = quarter_of(receiver.corner, k);
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

// What is shared out by exposure knows of no shadow that something far away throws on a part of an element: mean
// difference between what arrives at its quarters and what they are given.
float lost_shadow(const Hierarchy& hierarchy, const Node& element, const std::array<float, kPoints>& unoccluded,
                  const std::array<float, kPoints>& arriving) {
    const std::vector<Patch>& patches = hierarchy.faces().patches.patches;
    const std::uint32_t first = patches[element.patch].first_child;
    std::array<float, kPoints> given{};
    float sum = 0, all = 0;
    for (int k = 0; k < kPoints; ++k) {
        given[k] = unoccluded[k] * (first == kNone ? 1.0F : patches[first + k].exposure);
        sum += given[k];
        all += arriving[k];
    }
    float lost = 0;
    for (int k = 0; k < kPoints; ++k) {
        lost += std::abs(arriving[k] - given[k] * (all / std::max(sum, 1e-30F))) / kPoints;
    }
    return lost;
}

// Between the middles, m; infinite for the sky and distant lamps.
float distance_to(const Hierarchy& hierarchy, const Node& receiver, const Node& sender) {
    return is_infinite(hierarchy, sender) ? kInfinity : length(receiver.center - sender.center);
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

// Share by which the light of a spread-out cluster differs from that of its middle: second order in size over distance.
float far_field_error(const Node& receiver, const Node& sender) {
    const float distance = length(receiver.center - sender.center);
    const float ratio = sender.radius / std::max(distance, sender.radius);
    return 0.5F * ratio * ratio;
}

constexpr float kMostBrightness = 3;

bool is_uneven(const Lighting& lighting, NodeId element) {
    constexpr float kEven = 0.05F;  // spread over the mean
    return lighting.spread(element) > kEven * luminance(lighting.radiosity(element));
}

// How much brighter than the mean of an element what is seen of it is, by the rays. Hidden points are weighed against
// seen ones: that nearer ones count for more is left to brightness_of_nearer_parts, few rays would get it wrong to one
// side.
float brightness_of_seen_parts(const Lighting& lighting, NodeId sender, const ShadowRays& pairs, const Seen& seen) {
    double weights = 0, brightness = 0, seen_weights = 0, seen_brightness = 0;
    for (std::size_t i = 0; i < pairs.count; ++i) {
        const double weight = pairs.weights[i];
        const PlaceOnElement place = lighting.at(sender, pairs.targets[i]);  // more such points where it is exposed
        const double sent = weight * luminance(place.radiosity) / place.exposure;
        weights += weight;
        brightness += sent;
        seen_weights += seen.blocked[i] ? 0 : weight;
        seen_brightness += seen.blocked[i] ? 0 : sent;
    }
    const bool some = seen_weights > 0 && brightness > 0;
    return some ? static_cast<float>(seen_brightness / seen_weights * (weights / brightness)) : 1.0F;
}

// The same of an unoccluded element for its parts, which lie nearer to the receiver and farther.
float brightness_of_nearer_parts(const Lighting& lighting, const Node& receiver, NodeId sender, const Node& from) {
    const bool close = receiver.kind == NodeKind::kElement && are_close(receiver, from);
    const int parts = close ? kPoints * kPoints : kPoints;
    float sum = 0, weights = 0, all = 0;
    for (int i = 0; i < parts; ++i) {
        const std::array<Vec3, 3> quarter = quarter_of(from.corner, i % kPoints);
        const std::array<Vec3, 3> part = close ? quarter_of(quarter, i / kPoints) : quarter;
        const Vec3 y = centroid(part);
        const float brightness = luminance(lighting.mean_around(sender, y, close ? 2 : 1));
        all += brightness;
        for (int k = 0; k < (close ? kPoints : 1); ++k) {
            const Vec3 x = close ? centroid(quarter_of(receiver.corner, k)) : receiver.center;
            const Vec3 d = x - y;
            if (!in_front(x, from)) {
                continue;
            }
            const float towards =
                receiver.kind == NodeKind::kElement ? std::max(0.0F, -dot(d, receiver.normal)) : length(d);
            const float factor = close ? point_to_triangle(x, receiver.normal, part[0], part[1], part[2])
                                       : towards * dot(d, from.normal) / (length_squared(d) * length_squared(d));
            weights += factor;
            sum += factor * brightness;
        }
    }
    return weights > 0 && all > 0 ? sum / weights * (static_cast<float>(parts) / all) : 1.0F;
}

}  // namespace

Link estimate_link(const Hierarchy& hierarchy, const RayTracer& tracer, NodeId receiver, NodeId sender, int rays,
                   SampleSet samples, NearHits* hits, const Lighting* lighting) {
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
    const Seen seen = trace_shadow_rays(tracer, pairs, count, hierarchy.faces().patches.reach);
    if (samples == SampleSet::kLink && seen.visibility > 0 && seen.visibility < 1) {
        find_occluders(hierarchy, tracer, pairs, seen, link);
    }
    if (lighting && from.kind == NodeKind::kElement && from.patch == kNone && is_uneven(*lighting, sender)) {
        const float brightness = brightness_of_nearer_parts(*lighting, to, sender, from) *
                                 brightness_of_seen_parts(*lighting, sender, pairs, seen);
        link.brightness = std::clamp(brightness, 1 / kMostBrightness, kMostBrightness);
    }
    if (to.kind == NodeKind::kElement) {
        const std::array<float, kPoints> unoccluded = quarter_form_factors(hierarchy, to, from);
        std::array<float, kPoints> arriving{};
        for (int k = 0; k < kPoints; ++k) {
            arriving[k] = unoccluded[k] * seen.quarters[k];
        }
        link.form_factor = 0.25F * (unoccluded[0] + unoccluded[1] + unoccluded[2] + unoccluded[3]);
        const float mean = 0.25F * (arriving[0] + arriving[1] + arriving[2] + arriving[3]);
        link.visibility = link.form_factor > 0 ? mean / link.form_factor : 0.0F;
        const float arriving_error = set_linear_shape(arriving, link);
        float lost = 0;
        const Vec3 arriving_shape = link.shape;
        link.shape_error = set_linear_shape(unoccluded, link) * link.visibility;
        if (to.patch == kNone) {
            link.shape = arriving_shape;
        } else {  // shared out by exposure, which the rays saw too
            link.near_share = from.kind == NodeKind::kSky ? 0.0F : seen.near_share;
            const float noise = 2 * link.form_factor * seen.sampling_error;  // of a quarter of the rays
            lost = std::max(0.0F, lost_shadow(hierarchy, to, unoccluded, arriving) - noise);
        }
        link.level_error = link.form_factor * seen.sampling_error + lost;
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
