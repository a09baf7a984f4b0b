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
constexpr std::size_t kMeasured = 16;  // receivers that a sender is measured at, of those that it may light
constexpr float kSettled = 0.1F;       // share of the tolerance from which a sender is looked at closely
constexpr float kLeastSamples = 1;
constexpr float kNearError = 0.3F;  // of light from close by when it is interpolated

}  // namespace

Classifier::Classifier(const Solution& solution, const ClusterPoints& points, const RayTracer& tracer,
                       const ClassifySettings& settings)
    : solution_(solution),
      points_(points),
      tracer_(tracer),
      settings_(settings),
      cutter_(solution),
      near_(solution, tracer) {}

IrradianceVector Classifier::vector_at(NodeId sender, Vec3 x) const {
    const Node& node = hierarchy_of(solution_)[sender];
    if (!is_cluster(node)) {
        return irradiance_vector(solution_, sender, x);
    }
    const auto points = points_.of(sender);
    Rgb sum(0.0F);
    Vec3 vector(0.0F);
    for (const FacePoint& point : points) {
        const Vec3 to = point.position - x;
        const Vec3 direction = normalize_or_zero(to);
        const Rgb light =
            irradiance_from(point, 1, to, direction, 0.5F * node.area / static_cast<float>(points.size()));
        sum += light;
        vector += luminance(light) * direction;
    }
    const float size = length(vector), all = luminance(sum);
    return {all > 0 ? size / all * sum : Rgb(0.0F), size > 0 ? vector / size : Vec3(0, 0, 1)};
}

// Over at most `count` of the receivers that the sender may light: what others have of it is nothing anyway.
void Classifier::measure(Candidate& candidate, std::span<const Receiver> receivers, std::size_t count) {
    const Scene& scene = hierarchy_of(solution_).scene();
    const Node& node = hierarchy_of(solution_)[candidate.cut.sender];
    std::array<Vec3, kMeasured> vectors;
    std::size_t found = 0;
    Rgb sum(0.0F);
    Vec3 mean(0.0F);
    for (const Receiver& receiver : receivers) {
        if (found == count || is_below_horizon(scene, node, receiver.position, receiver.normal)) {
            continue;
        }
        const IrradianceVector v = vector_at(candidate.cut.sender, receiver.position);
        const float size = luminance(v.irradiance);
        if (size > 0) {
            vectors[found++] = size * v.direction;
            sum += v.irradiance;
            mean += size * v.direction;
            candidate.largest = std::max(candidate.largest, size);
            candidate.horizon = candidate.horizon || crosses_horizon(scene, node, receiver.position, receiver.normal);
        }
    }
    if (found == 0) {
        return;
    }
    sum /= static_cast<float>(found);
    mean /= static_cast<float>(found);
    const float size = length(mean), all = luminance(sum);
    candidate.irradiance = all > 0 ? size / all * sum : Rgb(0.0F);
    candidate.direction = size > 0 ? mean / size : Vec3(0, 0, 1);
    candidate.spread = 0;
    for (std::size_t j = 0; j < found; ++j) {
        candidate.spread = std::max(candidate.spread, 2 * length(vectors[j] - mean));
    }
}

// Luminance of the irradiance that a sender may bring to any point of a box.
float Classifier::bound(NodeId sender, const Box& box) const {
    const Node& node = hierarchy_of(solution_)[sender];
    if (node.kind == NodeKind::kLamp || node.kind == NodeKind::kSky) {
        return kInfinity;
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
            const FacePoint& target = points_.of(sender)[point % kClusterPoints];
            const Vec3 to = target.position - receiver.position;
            ++point;
            if (dot(to, receiver.normal) > 0 && dot(to, target.normal) < 0) {
                rays_.push_back({receiver.position, to, 0, kAlmost});
            }
        } else {
            const SenderPoint target = sender_point(solution_, sender, point, receiver.position, receiver.normal);
            if (target.weight > 0) {
                rays_.push_back({receiver.position, target.direction, 0, target.infinite ? kInfinity : kAlmost});
                ++point;
            }
        }
    }
    candidate.ray_count = static_cast<std::uint32_t>(rays_.size()) - candidate.first_ray;
}

// What interpolation may get wrong [eq. 2 and 3], and whether that is too much for this sender alone. tolerance: W/m2.
void Classifier::judge(Candidate& candidate, float tolerance) {
    std::uint32_t seen = 0;
    for (std::uint32_t k = candidate.first_ray; k < candidate.first_ray + candidate.ray_count; ++k) {
        seen += blocked_[k] ? 0 : 1;
    }
    const auto count = static_cast<float>(candidate.ray_count);
    candidate.visibility = count > 0 ? static_cast<float>(seen) / count : candidate.cut.visibility;
    if (!candidate.matters) {
        return;
    }
    const float brings = luminance(candidate.irradiance);
    const float v = candidate.visibility;
    const bool mixed =
        (seen > 0 && seen < candidate.ray_count) || (candidate.cut.visibility > 0 && candidate.cut.visibility < 1);
    // That all rays said the same is no proof.
    const float doubt = 1 / (count + 2);
    candidate.resample_visibility = (mixed ? 1 : doubt) * brings > tolerance;
    candidate.visibility_error = std::max(std::sqrt(v * (1 - v)), doubt) * brings;
    candidate.form_factor_error =
        (candidate.resample_visibility ? 1 : v) *
        std::max({candidate.spread, candidate.spread_bound, candidate.horizon ? brings : 0.0F});
    candidate.resample_form_factor = candidate.form_factor_error > tolerance;
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

// tolerance: W/m2
void Classifier::add_near_light(std::span<const Receiver> receivers, float tolerance, Site& site) {
    if (cut_.near.empty()) {
        return;
    }
    origins_.clear();
    for (const Receiver& receiver : receivers) {
        origins_.push_back({receiver.position, receiver.normal});
    }
    const std::size_t first = site.beams.size();
    near_.for_each_hit(cut_.near, origins_, [&](Vec3 direction, Rgb irradiance) {
        site.beams.push_back({direction, irradiance});
    });
    counts_.near_rays += 2 * kNearDirections;
    float most = 0;
    for (const NearOrigin& origin : origins_) {
        most = std::max(most, luminance(light_of(std::span(site.beams).subspan(first), origin.normal)));
    }
    if (kNearError * most > tolerance) {
        site.near = cut_.near;
        site.beams.resize(first);
    }
}

Site Classifier::classify(std::span<const Receiver> receivers) {
    Box bounds;
    float irradiance = 0, radiosity = 0, reflectance = 0;
    places_.clear();
    const float share = 1 / static_cast<float>(receivers.size());
    for (const Receiver& receiver : receivers) {
        bounds.extend(receiver.position);
        irradiance += share * receiver.irradiance;
        radiosity += share * receiver.reflectance * receiver.irradiance;
        reflectance += share * receiver.reflectance;
        if (receiver.place != kNone) {
            places_.push_back(receiver.place);
        }
    }
    cutter_.build({places_, bounds, irradiance}, cut_);
    Site site;
    const float threshold = settings_.threshold * std::max(radiosity, settings_.least_radiosity);
    const float in_irradiance = threshold / std::max(reflectance, 0.02F);
    add_near_light(receivers, in_irradiance, site);
    candidates_.clear();
    rays_.clear();
    float all = 0;
    for (const CutSender& sender : cut_.senders) {
        Candidate candidate;
        candidate.cut = sender;
        measure(candidate, receivers, 1);
        if (candidate.largest > 0) {
            all += luminance(candidate.irradiance);
            candidates_.push_back(candidate);
        }
    }
    for (Candidate& candidate : candidates_) {
        const float most = bound(candidate.cut.sender, bounds);
        candidate.matters = most > kSettled * in_irradiance;
        if (is_close(hierarchy_of(solution_).scene(), hierarchy_of(solution_)[candidate.cut.sender], bounds)) {
            candidate.spread_bound = most;
        }
        if (!candidate.matters) {
            add_rays(candidate, receivers, kFewPairs);
        } else {
            const float wanted = static_cast<float>(settings_.samples) * luminance(candidate.irradiance) / all;
            measure(candidate, receivers, kMeasured);
            add_rays(candidate, receivers, std::clamp(static_cast<std::uint32_t>(wanted), kLeastPairs, kMostPairs));
        }
    }
    blocked_.resize(rays_.size());
    tracer_.occluded(rays_, blocked_, RayMask::kLight, Coherence::kIncoherent);
    for (Candidate& candidate : candidates_) {
        judge(candidate, in_irradiance);
    }
    keep_to_budget(in_irradiance);
    for (const Candidate& candidate : candidates_) {
        if (candidate.resample_form_factor || candidate.resample_visibility) {
            counts_.both += candidate.resample_form_factor && candidate.resample_visibility;
            counts_.only_visibility += !candidate.resample_form_factor;
            counts_.only_form_factor += !candidate.resample_visibility;
            const float samples = static_cast<float>(settings_.samples) * luminance(candidate.irradiance) / all;
            site.senders.push_back({candidate.cut.sender, candidate.resample_form_factor, candidate.resample_visibility,
                                    std::max(kLeastSamples, samples), candidate.visibility, candidate.irradiance,
                                    candidate.direction});
        } else {
            site.beams.push_back({candidate.direction, candidate.visibility * candidate.irradiance});
        }
    }
    std::sort(site.senders.begin(), site.senders.end(),
              [](const SiteSender& a, const SiteSender& b) { return a.sender < b.sender; });
    counts_.points += 1;
    counts_.senders += candidates_.size();
    counts_.visibility_rays += rays_.size();
    return site;
}

}  // namespace gg
