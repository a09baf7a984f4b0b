#include "gather/classify.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "gather/error_budget.h"
#include "gather/sender_light.h"
#include "gather/sender_place.h"

namespace gg {

namespace {

constexpr float kAlmost = 0.9999F;  // of the way to a sender
constexpr std::uint32_t kFewPairs = 2, kLeastPairs = 4, kMostPairs = 64;
constexpr std::size_t kMeasured = 16;  // receivers that a sender is measured at, at least
constexpr std::size_t kGlanced = 3;    // and at so many first
constexpr float kPromising = 0.3F;     // share of the tolerance from which a sender is measured in full
constexpr float kGlaring = 4;          // times the irradiance of the place, of a sender's radiosity
constexpr float kFewestSamples = 0.75F, kMostSamples = 4;  // by brightness
constexpr float kSettled = 0.1F;  // share of the tolerance from which a sender is looked at closely
constexpr float kLeastSamples = 1;
constexpr float kUnmixed = 0.25F;   // share of the samples of a sender that all or none of its rays met
constexpr float kFullReach = 0.7F;  // share of the reach within which everything is near

// Whether all of a box lies on the back of a plane.
bool is_behind(const Box& box, Vec3 on_plane, Vec3 normal) {
    return dot(box.center() - on_plane, normal) + 0.5F * dot(box.extent(), glm::abs(normal)) <= 0;
}

}  // namespace

float threshold_at(const ClassifySettings& settings, float radiosity) {
    constexpr float kDarkest = 0.1F;  // of the mean radiosity: darker places tolerate no less
    return settings.threshold * std::max(radiosity, kDarkest * settings.mean_radiosity);
}

Classifier::Classifier(const Solution& solution, const NodeOrder& order, const ClusterPoints& points,
                       const RayTracer& tracer, const ClassifySettings& settings)
    : solution_(solution),
      order_(order),
      points_(points),
      tracer_(tracer),
      settings_(settings),
      cutter_(solution),
      meter_(solution, points),
      surroundings_(solution, order, tracer),
      sky_(tracer, hierarchy_of(solution).scene().world) {}

// Luminance of the irradiance that a sender may bring to any point of a box.
float Classifier::bound(NodeId sender, const Box& box) const {
    const Node& node = hierarchy_of(solution_)[sender];
    if (node.kind == NodeKind::kLamp) {
        return kInfinity;
    }
    if (node.kind == NodeKind::kElement && is_behind(box, node.corner[0], node.normal)) {
        return 0;
    }
    const float distance = std::max(0.0F, length(node.center - box.center()) - node.radius - 0.5F * box.diameter());
    const float factor = node.area / std::max(kPi * distance * distance, 1e-20F);
    return std::min(factor, 1.0F) * luminance(radiosity_of(solution_, sender));
}

void Classifier::add_rays(Candidate& candidate, std::span<const Receiver> receivers, std::uint32_t count) {
    const NodeId sender = candidate.cut.sender;
    const bool cluster = is_cluster(hierarchy_of(solution_)[sender]);
    candidate.first_ray = static_cast<std::uint32_t>(rays_.size());
    const auto wanted = candidate.first_ray + count;
    const std::uint32_t most = count + 2 * static_cast<std::uint32_t>(receivers.size());
    std::uint32_t point = 0;  // of the sender: a prefix, whichever receivers see it
    for (std::uint32_t k = 0; k < most && rays_.size() < wanted; ++k) {
        const Receiver& receiver = receivers[(sender + k) % receivers.size()];
        if (cluster) {
            const FacePoint target = points_.of(sender)[point % kClusterPoints];
            const Vec3 to = target.position - receiver.position;
            ++point;
            if (receiver.faces(to) && dot(to, target.normal) < 0) {
                rays_.push_back({receiver.position, to, 0, kAlmost});
            }
        } else {
            const SenderPoint target =
                SenderSampler(solution_, sender, receiver.position, receiver.shading_normal).point(point);
            if (target.weight > 0 && receiver.faces(target.direction)) {
                rays_.push_back({receiver.position, target.direction, 0, target.infinite ? kInfinity : kAlmost});
                ++point;
            }
        }
    }
    candidate.ray_count = static_cast<std::uint32_t>(rays_.size()) - candidate.first_ray;
}

// What interpolation may get wrong [eq. 2 and 3], and whether that is too much for this sender alone. irradiance:
// of the place; tolerance: W/m2.
void Classifier::judge(Candidate& candidate, float irradiance, float tolerance) {
    std::uint32_t seen = 0;
    for (std::uint32_t k = candidate.first_ray; k < candidate.first_ray + candidate.ray_count; ++k) {
        seen += blocked_[k] ? 0 : 1;
    }
    const auto count = static_cast<float>(candidate.ray_count);
    candidate.visibility = count > 0 ? static_cast<float>(seen) / count : candidate.cut.visibility;
    if (!candidate.matters) {
        return;
    }
    const float brings = luminance(candidate.brings.irradiance);
    const float v = candidate.visibility;
    const bool lamp = hierarchy_of(solution_)[candidate.cut.sender].kind == NodeKind::kLamp;
    if (seen == 0 && !lamp) {
        return;  // rays in all directions will find what little can be seen of it
    }
    candidate.mixed = v > 0 && v < 1;
    // That all rays said the same is no proof.
    const float doubt = 1 / (count + 2);
    candidate.resample_visibility = (candidate.mixed ? 1 : doubt) * brings > tolerance;
    candidate.visibility_error = std::max(std::sqrt(v * (1 - v)), doubt) * brings;
    candidate.form_factor_error =
        (candidate.resample_visibility ? 1 : v) *
        std::max({candidate.brings.spread, candidate.spread_bound, candidate.brings.horizon ? brings : 0.0F});
    candidate.resample_form_factor = candidate.form_factor_error > tolerance;
    // Rays in all directions would meet it too seldom.
    if (!lamp && luminance(radiosity_of(solution_, candidate.cut.sender)) > kGlaring * irradiance) {
        candidate.resample_form_factor = true;
    }
    // What few rays found visible is not all visible; and what is hidden is not among these senders, to make up for it.
    candidate.resample_visibility = candidate.resample_visibility || (candidate.resample_form_factor && !lamp);
}

// m, the farthest that links know of, or that stands in the way of the first rays.
float Classifier::occluder_of(const Candidate& candidate) const {
    constexpr int kFollowed = 8;
    float farthest = candidate.cut.occluder;
    int followed = 0;
    for (std::uint32_t k = candidate.first_ray; k < candidate.first_ray + candidate.ray_count; ++k) {
        if (blocked_[k] && followed++ < kFollowed) {
            Ray ray = rays_[k];
            const float metre = 1 / length(ray.direction);  // in the ray's t
            ray.far = std::min(ray.far, hierarchy_of(solution_).extent_from(ray.origin) * metre);
            farthest = std::max(farthest, tracer_.farthest_hit(ray, RayMask::kLight) / metre);
        }
    }
    return farthest;
}

// Resamples more where the errors that are left add up to too much.
void Classifier::keep_to_budget(float tolerance) {
    errors_.clear();
    resampled_.clear();
    for (Candidate& candidate : candidates_) {
        for (const auto& [error, resampled] : {std::pair(candidate.form_factor_error, &candidate.resample_form_factor),
                                               std::pair(candidate.visibility_error, &candidate.resample_visibility)}) {
            if (!*resampled) {
                errors_.push_back(error);
                resampled_.push_back(resampled);
            }
        }
    }
    for (const std::size_t i : beyond_budget(errors_, tolerance)) {
        *resampled_[i] = true;
    }
}

Site Classifier::classify(std::span<const Receiver> receivers, float threshold) {
    Box bounds;
    places_.clear();
    for (const Receiver& receiver : receivers) {
        bounds.extend(receiver.position);
        if (receiver.place != kNone) {
            places_.push_back(receiver.place);
        }
    }
    const ReceiverMeans means = means_of(receivers);
    const float irradiance = means.irradiance;
    const Scene& scene = hierarchy_of(solution_).scene();
    cutter_.build({places_, bounds, irradiance}, cut_);
    surroundings_.look_from(receivers);
    meter_.look_from(receivers);
    Site site;
    site.reach = {kFullReach * settings_.reach * bounds.diameter(), settings_.reach * bounds.diameter()};
    site.near_cells = surroundings_.near_cells(site.reach.none);
    const bool looked_at = threshold > 0;
    if (!looked_at) {
        threshold = threshold_at(settings_, means.radiosity);
    }
    const float tolerance = threshold / std::max(means.reflectance, 0.02F);
    const float brightness = settings_.mean_radiosity > 0 ? means.radiosity / settings_.mean_radiosity : 1;
    const float samples =
        static_cast<float>(settings_.samples) * std::clamp(std::sqrt(brightness), kFewestSamples, kMostSamples);
    candidates_.clear();
    rays_.clear();
    float all = 0;
    for (const CutSender& sender : cut_.senders) {
        const Node& node = hierarchy_of(solution_)[sender.sender];
        Candidate candidate;
        candidate.cut = sender;
        candidate.bound = bound(sender.sender, bounds);
        if (node.kind != NodeKind::kSky && (node.kind == NodeKind::kLamp || candidate.bound > tolerance)) {
            const bool lamp = node.kind == NodeKind::kLamp;
            candidate.brings = meter_.measure(sender.sender, lamp ? kMeasured : kGlanced);
            if (!lamp && candidate.brings.largest > kPromising * tolerance) {
                candidate.brings = meter_.measure(sender.sender, kMeasured);
            }
            if (candidate.brings.largest > (lamp ? 0 : tolerance)) {
                all += luminance(candidate.brings.irradiance);
                candidates_.push_back(candidate);
            }
        }
    }
    all = std::max(all, irradiance);
    for (Candidate& candidate : candidates_) {
        candidate.matters = candidate.brings.largest > kSettled * tolerance;
        if (is_close(scene, hierarchy_of(solution_)[candidate.cut.sender], bounds)) {
            candidate.spread_bound = std::min(candidate.bound, 4 * candidate.brings.largest);
        }
        const float wanted = samples * luminance(candidate.brings.irradiance) / all;
        add_rays(
            candidate, receivers,
            candidate.matters ? std::clamp(static_cast<std::uint32_t>(wanted), kLeastPairs, kMostPairs) : kFewPairs);
    }
    blocked_.resize(rays_.size());
    tracer_.occluded(rays_, blocked_, RayMask::kLight, Coherence::kIncoherent);
    for (Candidate& candidate : candidates_) {
        judge(candidate, irradiance, tolerance);
    }
    keep_to_budget(tolerance);
    for (const Candidate& candidate : candidates_) {
        const bool lamp = hierarchy_of(solution_)[candidate.cut.sender].kind == NodeKind::kLamp;
        const bool resampled = candidate.resample_form_factor || candidate.resample_visibility;
        if (resampled) {
            counts_.both += candidate.resample_form_factor && candidate.resample_visibility;
            counts_.only_visibility += !candidate.resample_form_factor;
            counts_.only_form_factor += !candidate.resample_visibility;
            const float importance = luminance(candidate.brings.irradiance) / all;  // [eq. 1]
            float wanted = samples * importance;
            if (looked_at) {
                wanted = shadow_samples(
                    shadow_on(means, hierarchy_of(solution_), candidate.cut.sender, candidate.brings.direction,
                              luminance(candidate.brings.irradiance), occluder_of(candidate)),
                    threshold);
            }
            site.senders.push_back({candidate.cut.sender, candidate.resample_form_factor, candidate.resample_visibility,
                                    std::max(kLeastSamples, (candidate.mixed ? 1 : kUnmixed) * wanted),
                                    candidate.visibility, candidate.brings.irradiance, candidate.brings.direction,
                                    is_soft(hierarchy_of(solution_)[candidate.cut.sender])});
        } else if (lamp) {
            site.beams.push_back({candidate.brings.direction, candidate.visibility * candidate.brings.irradiance});
        }
        if (!lamp && resampled) {
            site.apart.push_back(order_.range(candidate.cut.sender));
        }
    }
    std::sort(site.senders.begin(), site.senders.end(),
              [](const SiteSender& a, const SiteSender& b) { return a.sender < b.sender; });
    std::sort(site.apart.begin(), site.apart.end());
    surroundings_.add_to(site.table, site.apart, site.reach);
    const std::size_t sky_rays = sky_.ray_count();
    const float sky = std::max(luminance(scene.world), 1e-20F);
    sky_.find(receivers, surroundings_, settings_.sky_leaf * std::max(irradiance, tolerance) / sky, site.leaves,
              site.table);
    counts_.points += 1;
    counts_.senders += cut_.senders.size();
    counts_.visibility_rays += rays_.size() + sky_.ray_count() - sky_rays;
    counts_.near_rays += surroundings_.ray_count();
    // There are many sites, and they stay.
    site.senders.shrink_to_fit();
    site.apart.shrink_to_fit();
    site.leaves.shrink_to_fit();
    site.beams.shrink_to_fit();
    return site;
}

}  // namespace gg
