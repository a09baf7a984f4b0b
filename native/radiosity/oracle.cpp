#include "radiosity/oracle.h"

#include <algorithm>
#include <cmath>

#include "core/distance.h"
#include "radiosity/link_estimate.h"

namespace gg {

namespace {

// Sizes as shares of the extent of the light (ReferenceWhite::extent).
constexpr float kDetail = 0.4F;        // smaller receivers may be wrong by more, the smaller their area
constexpr float kLargeCluster = 0.1F;  // larger clusters are looked into
constexpr float kSmallestElement = 0.03F;
constexpr float kSmallestCluster = 0.04F;
constexpr float kSmallestSky = 0.02F;   // sr
constexpr float kLargestSky = 0.5F;     // sr
constexpr float kInsignificant = 0.1F;  // share of the tolerance below which four rays will do
constexpr float kDarkest = 0.01F;       // irradiance below this share of the white tolerates no less
constexpr float kClusterError = 5;      // clusters may be wrong by so much more: their faces look around themselves
constexpr float kLeastReflectance = 0.05F;
constexpr float kLeastContrast = 0.1F;  // of a sender to its surroundings that is always counted
constexpr float kLeastExposed = 0.25F;
constexpr float kLocal = 0.5F;  // size and distance of senders, as shares of the receiver's, that are looked at closely
constexpr float kLocalFactor = 0.25F;  // form factor where such a sender stands
constexpr float kShown = 0.5F;         // share of a cluster's area, both sides, that may face a receiver
constexpr float kHotSpots = 3;         // how much brighter than its mean a cluster may be that has emitting faces

// How many times smaller than what counts in full, >= 1.
float small_size(float radius, const RefineSettings& settings) {
    return 1 / std::clamp(size_in_details(radius, settings), 1e-6F, 1.0F);
}

}  // namespace

float size_in_details(float radius, const RefineSettings& settings) {
    return 2 * radius / std::max(kDetail * settings.white.extent, 1e-12F);
}

float allowed_difference(float irradiance, const RefineSettings& settings) {
    const float white = settings.white.irradiance;
    return settings.tolerance * std::sqrt(white * std::max(irradiance, kDarkest * white));
}

float allowed_error(const Node& receiver, float irradiance, const RefineSettings& settings) {
    const float small = small_size(receiver.radius, settings);
    return allowed_difference(irradiance, settings) * small * small;
}

float seen_reflectance(const Node& node) {
    return std::sqrt(std::max(luminance(node.reflectance), kLeastReflectance));
}

bool can_split(const Node& node, const RefineSettings& settings) {
    switch (node.kind) {
        case NodeKind::kInstances:
            return true;
        case NodeKind::kCluster:
            return node.child_count > 0 || 2 * node.radius > kSmallestCluster * settings.white.extent;
        case NodeKind::kElement:
            return node.child_count > 0 || 2 * node.radius > kSmallestElement * settings.white.extent;
        case NodeKind::kSky:
            return node.area > kSmallestSky;
        case NodeKind::kLamp:
            return false;
    }
    return false;
}

namespace {

// Faces of clusters look around themselves in the end; links to them only have to guide.
float error_for_faces(const Node& receiver, const Node& sender) {
    return receiver.kind == NodeKind::kCluster && is_surface(sender) ? kClusterError : 1.0F;
}

// Radiosity of the sender as its brightest part could have it.
float strength(const Node& sender, float radiosity) {
    return is_cluster(sender) && luminance(sender.emission) > 0 ? kHotSpots * radiosity : radiosity;
}

// How much brighter than its mean are those faces of a cluster that are exposed.
float exposed_share(const Node& sender) {
    return is_cluster(sender) ? 1 / std::max(sender.exposure, kLeastExposed) : 1.0F;
}

// Turns a link's form factor into one that multiplies the mean radiosity. What rays of near links meet are exposed
// faces, which have nearly all the light.
float surface_shown(const Node& sender, bool near) {
    if (!is_cluster(sender)) {
        return 1;
    }
    return near ? exposed_share(sender) : kShown * sender.area;
}

// A large cluster of large faces, or that has some of its own, such as a wall of two triangles: no directional form
// describes it as well as its faces do, and they are few.
bool has_large_faces(const Hierarchy& hierarchy, const Node& node, const RefineSettings& settings) {
    const float large = kLargeCluster * settings.white.extent;
    if (node.kind != NodeKind::kCluster || 2 * node.radius <= large) {
        return false;
    }
    const ClusterTree::Node& range = hierarchy.tree_node(node);
    const auto count = static_cast<float>(range.end - range.begin);
    return range.direct_end > range.begin || node.area > count * large * large;
}

// Whole objects, large and small, lit and in the dark: samples by area would see the largest only.
bool is_mixed(const Node& node, const RefineSettings& settings) {
    return node.kind == NodeKind::kInstances && 2 * node.radius > kLargeCluster * settings.white.extent;
}

// Share of a sender's light that comes from unknown parts of it: what is seen of it in part may be its bright part (lit
// places see each other), and close by, the nearer part counts for more.
float uneven_share(const Node& receiver, const Node& sender, const Link& link) {
    if (!is_surface(sender)) {
        return 0;
    }
    constexpr float kNearer = 0.3F;
    const float size = std::min(1.0F, sender.radius / std::max(length(receiver.center - sender.center), 1e-12F));
    return link.form_factor * (std::sqrt(link.visibility * (1 - link.visibility)) + kNearer * size * link.visibility);
}

// A small sender close to a large receiver brings next to nothing in the mean, and much to the place where it stands.
// Form factor there, times what may be wrong on all of the receiver over what may be wrong on a receiver of that
// place's size.
float local_share(const Hierarchy& hierarchy, const Node& receiver, const Node& sender,
                  const RefineSettings& settings) {
    if (receiver.kind != NodeKind::kElement || is_infinite(hierarchy, sender) ||
        sender.radius > kLocal * receiver.radius) {
        return 0;
    }
    const float distance = distance_to_triangle(sender.center, receiver.corner);
    const float place = distance + sender.radius;
    if (place > kLocal * receiver.radius) {
        return 0;
    }
    const float factor = sender.radius * sender.radius / (place * place);
    const float scale = small_size(receiver.radius, settings) / small_size(place, settings);
    return kLocalFactor * factor * scale * scale;
}

Verdict side_to_split(const Node& receiver, const Node& sender, const RefineSettings& settings) {
    const bool receiver_splits = can_split(receiver, settings);
    const bool sender_splits = can_split(sender, settings);
    if (!receiver_splits && !sender_splits) {
        return Verdict::kAccept;
    }
    if (!sender_splits) {
        return Verdict::kSplitReceiver;
    }
    if (!receiver_splits) {
        return Verdict::kSplitSender;
    }
    const bool sender_larger =
        sender.kind == NodeKind::kSky ? sender.area > kLargestSky : sender.radius > receiver.radius;
    return sender_larger ? Verdict::kSplitSender : Verdict::kSplitReceiver;
}

}  // namespace

bool still_good(const Hierarchy& hierarchy, const Lighting& lighting, const Link& link,
                const RefineSettings& settings) {
    const Node& receiver = hierarchy[link.receiver];
    const Node& sender = hierarchy[link.sender];
    const float reflectance = seen_reflectance(receiver);
    const float light = strength(sender, luminance(lighting.radiosity(link.sender)));
    const float sent = light * surface_shown(sender, link.near);
    const float irradiance =
        std::max(luminance(lighting.irradiance(link.receiver)), sent * link.form_factor * link.visibility);
    // Form factors of all that a point sees sum to one: what one link has too much of, the others have too little, and
    // they have the brightness of the surroundings. So the course of a form factor matters as far as the sender stands
    // out. (To refine it on its own would leave the others' share of the error behind.)
    const float surroundings =
        link.near || !is_cluster(sender) ? 2 * irradiance : 2 * irradiance * surface_shown(sender, false);
    const float standing_out = std::max(sent - surroundings, kLeastContrast * sent);
    const float peak = link.visibility > 0 ? local_share(hierarchy, receiver, sender, settings) : 0.0F;
    const float uneven =
        lighting.spread(link.sender) * surface_shown(sender, link.near) * uneven_share(receiver, sender, link);
    return reflectance * (standing_out * link.shape_error + sent * link.level_error + uneven +
                          light * exposed_share(sender) * peak) <=
           error_for_faces(receiver, sender) * allowed_error(receiver, irradiance, settings);
}

bool may_be_uneven(const Hierarchy& hierarchy, const Lighting& lighting, const Link& link,
                   const RefineSettings& settings) {
    constexpr float kNegligible = 0.3F;  // share of the tolerance
    const Node& receiver = hierarchy[link.receiver];
    const float arriving = lighting.spread(link.sender) * link.form_factor * link.visibility;
    return hierarchy[link.sender].kind == NodeKind::kElement &&
           seen_reflectance(receiver) * arriving >
               kNegligible * allowed_error(receiver, luminance(lighting.irradiance(link.receiver)), settings);
}

Decision decide(const Hierarchy& hierarchy, const Lighting& lighting, const RayTracer& tracer, NodeId receiver_id,
                NodeId sender_id, const RefineSettings& settings, NearHits& hits) {
    const Node& receiver = hierarchy[receiver_id];
    const Node& sender = hierarchy[sender_id];
    const bool self = receiver_id == sender_id;
    if (!self && never_exchange(hierarchy, receiver, sender)) {
        return {Verdict::kDrop, {}};
    }
    if (self && receiver.kind == NodeKind::kElement) {
        return {Verdict::kDrop, {}};
    }
    const float irradiance = luminance(lighting.irradiance(receiver_id));
    const float allowed = error_for_faces(receiver, sender) * allowed_error(receiver, irradiance, settings);
    const float reflectance = seen_reflectance(receiver);
    const float light = strength(sender, luminance(lighting.radiosity(sender_id)));
    const float most = reflectance * light * (self ? 1.0F : form_factor_bound(hierarchy, receiver, sender));
    if (most <= kInsignificant * allowed) {
        Link link = estimate_link(hierarchy, tracer, receiver_id, sender_id, 4, SampleSet::kLink, &hits, &lighting);
        link.shape_error = 0;
        link.level_error = form_factor_bound(hierarchy, receiver, sender) / surface_shown(sender, link.near);
        return {Verdict::kAccept, link};
    }
    const Verdict split = self ? (can_split(receiver, settings) ? Verdict::kSplitSelf : Verdict::kAccept)
                               : side_to_split(receiver, sender, settings);
    if (has_large_faces(hierarchy, receiver, settings) || is_mixed(receiver, settings)) {
        return {self ? Verdict::kSplitSelf : Verdict::kSplitReceiver, {}};
    }
    if (has_large_faces(hierarchy, sender, settings) || is_mixed(sender, settings)) {
        return {Verdict::kSplitSender, {}};
    }
    // As many rays as it takes to believe that nothing, or everything, is in between.
    // Neighbours of small receivers average what noise remains.
    const bool small = 2 * receiver.radius < kDetail * settings.white.extent;
    const float most_rays = small ? 16.0F : 64.0F;
    const int rays = static_cast<int>(std::clamp(std::ceil(2 * most / allowed), small ? 4.0F : 32.0F, most_rays));
    // Shadows of lamps are worth looking at on smaller receivers, with fewer rays for each.
    const int first_rays = sender.kind == NodeKind::kLamp ? std::max(rays / 2, 4) : rays;
    const Link judged =
        estimate_link(hierarchy, tracer, receiver_id, sender_id, first_rays, SampleSet::kJudge, nullptr);
    if (split != Verdict::kAccept && !still_good(hierarchy, lighting, judged, settings)) {
        return {split, {}};
    }
    Link link = estimate_link(hierarchy, tracer, receiver_id, sender_id, rays, SampleSet::kLink, &hits, &lighting);
    link.shape_error = judged.shape_error;
    link.level_error = judged.level_error;
    return {Verdict::kAccept, link};
}

}  // namespace gg
