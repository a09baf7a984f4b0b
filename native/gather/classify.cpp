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
// Of the tolerance, that few rays may be off. toy_room, library, attic at half size: rel_rmse .0289, .0328, .0324
// without closer looks; .0281, .0324, .0312 with this; .0279, .0321, .0312 with 2, for twice the time.
constexpr float kLeftError = 2.6F;
// Of the tolerance, that single rays at what is near may be off. toy_room: .0281 without such cells, .0274 with 2,
// .0266 with this for a third more near rays, .0264 with all cells.
constexpr float kCloseError = 1.4F;

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

// What may bring so much that rays look at it by itself; `left_` is the rest.
void Classifier::find_candidates(Place& place) {
    candidates_.clear();
    left_.clear();
    for (const CutSender& sender : cut_.senders) {
        const NodeKind kind = hierarchy_of(solution_)[sender.sender].kind;
        if (kind == NodeKind::kSky) {
            continue;
        }
        const bool lamp = kind == NodeKind::kLamp;
        Candidate candidate;
        candidate.cut = sender;
        candidate.bound = meter_.bound(sender.sender, place.bounds);
        float may_bring = candidate.bound;
        if (lamp || candidate.bound > place.tolerance) {
            candidate.brings = meter_.measure(sender.sender, lamp ? kMeasured : kGlanced);
            if (!lamp && candidate.brings.largest > kPromising * place.tolerance) {
                candidate.brings = meter_.measure(sender.sender, kMeasured);
            }
            may_bring = candidate.brings.largest;
        }
        if (may_bring > (lamp ? 0 : place.tolerance)) {
            place.all += luminance(candidate.brings.irradiance);
            candidates_.push_back(candidate);
        } else if (!lamp) {
            left_.push_back({sender.sender, may_bring});
        }
    }
    place.all = std::max(place.all, place.means.irradiance);
}

// Decides of every candidate what is resampled.
void Classifier::look_at_candidates(std::span<const Receiver> receivers, const Place& place) {
    const Hierarchy& hierarchy = hierarchy_of(solution_);
    rays_.clear();
    for (Candidate& candidate : candidates_) {
        candidate.matters = candidate.brings.largest > kSettled * place.tolerance;
        if (is_close(hierarchy.scene(), hierarchy[candidate.cut.sender], place.bounds)) {
            candidate.spread_bound = std::min(candidate.bound, 4 * candidate.brings.largest);
        }
        const auto wanted = static_cast<std::uint32_t>(place.samples_of(candidate.brings));
        add_rays(candidate, receivers, candidate.matters ? std::clamp(wanted, kLeastPairs, kMostPairs) : kFewPairs);
    }
    blocked_.resize(rays_.size());
    tracer_.occluded(rays_, blocked_, RayMask::kLight, Coherence::kIncoherent);
    for (Candidate& candidate : candidates_) {
        judge(candidate, place.means.irradiance, place.tolerance);
    }
    keep_to_budget(place.tolerance);
}

// Puts the candidates that are resampled into the site, and lamps; the others are left, too.
void Classifier::settle_candidates(const Place& place, Site& site) {
    const Hierarchy& hierarchy = hierarchy_of(solution_);
    for (const Candidate& candidate : candidates_) {
        const NodeId sender = candidate.cut.sender;
        const bool lamp = hierarchy[sender].kind == NodeKind::kLamp;
        const SenderMeasure& brings = candidate.brings;
        if (candidate.resample_form_factor || candidate.resample_visibility) {
            counts_.both += candidate.resample_form_factor && candidate.resample_visibility;
            counts_.only_visibility += !candidate.resample_form_factor;
            counts_.only_form_factor += !candidate.resample_visibility;
            float wanted = place.samples_of(brings);
            if (place.looked_at) {
                wanted = shadow_samples(shadow_on(place.means, hierarchy, sender, brings.direction,
                                                  luminance(brings.irradiance), occluder_of(candidate)),
                                        place.threshold);
            }
            site.senders.push_back({sender, candidate.resample_form_factor, candidate.resample_visibility,
                                    std::max(kLeastSamples, (candidate.mixed ? 1 : kUnmixed) * wanted),
                                    candidate.visibility, brings.irradiance, brings.direction,
                                    is_soft(hierarchy[sender])});
            if (!lamp) {
                site.apart.push_back(order_.range(sender));
            }
        } else if (lamp) {
            site.beams.push_back({brings.direction, candidate.visibility * brings.irradiance});
        } else {
            left_.push_back({sender, luminance(brings.irradiance)});
        }
    }
    std::sort(site.senders.begin(), site.senders.end(),
              [](const SiteSender& a, const SiteSender& b) { return a.sender < b.sender; });
    std::sort(site.apart.begin(), site.apart.end());
}

Classifier::Place Classifier::place_of(std::span<const Receiver> receivers, float threshold) const {
    Place place;
    for (const Receiver& receiver : receivers) {
        place.bounds.extend(receiver.position);
    }
    place.means = means_of(receivers);
    place.looked_at = threshold > 0;
    place.threshold = place.looked_at ? threshold : threshold_at(settings_, place.means.radiosity);
    place.tolerance = place.threshold / std::max(place.means.reflectance, 0.02F);
    const float brightness = settings_.mean_radiosity > 0 ? place.means.radiosity / settings_.mean_radiosity : 1;
    place.samples =
        static_cast<float>(settings_.samples) * std::clamp(std::sqrt(brightness), kFewestSamples, kMostSamples);
    return place;
}

Site Classifier::classify(std::span<const Receiver> receivers, float threshold) {
    Place place = place_of(receivers, threshold);
    places_.clear();
    for (const Receiver& receiver : receivers) {
        if (receiver.place != kNone) {
            places_.push_back(receiver.place);
        }
    }
    const float irradiance = place.means.irradiance;
    cutter_.build({places_, place.bounds, irradiance}, cut_);
    surroundings_.look_from(receivers);
    meter_.look_from(receivers);
    Site site;
    const float reach = settings_.reach * place.bounds.diameter();
    site.reach = {kFullReach * reach, reach};
    site.near_cells = surroundings_.near_cells(site.reach.none);
    find_candidates(place);
    look_at_candidates(receivers, place);
    settle_candidates(place, site);
    surroundings_.look_closer(receivers,
                              worth_closer_look(solution_, place.means.position, left_, kLeftError * place.tolerance));
    surroundings_.add_to(site.table, site.apart, site.reach);
    site.close_cells = site.near_cells & worth_close_cells(surroundings_, site.apart, site.table, site.reach,
                                                           kCloseError * place.tolerance);
    const std::size_t sky_rays = sky_.ray_count();
    const float sky = std::max(luminance(hierarchy_of(solution_).scene().world), 1e-20F);
    sky_.find(receivers, surroundings_, settings_.sky_leaf * std::max(irradiance, place.tolerance) / sky, site.leaves,
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
