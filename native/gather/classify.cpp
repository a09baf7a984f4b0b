#include "gather/classify.h"

#include <algorithm>
#include <cmath>

#include "gather/sender_light.h"

namespace gg {

namespace {

constexpr float kAlmost = 0.9999F;  // of the way to a sender
constexpr std::uint32_t kLeastPairs = 4, kMostPairs = 16;
constexpr float kSettled = 0.1F;    // share of the threshold below which links are believed
constexpr float kLeastSamples = 4;

}  // namespace

ClassifyCounts& ClassifyCounts::operator+=(const ClassifyCounts& other) {
    sites += other.sites;
    senders += other.senders;
    rays += other.rays;
    both += other.both;
    only_visibility += other.only_visibility;
    only_form_factor += other.only_form_factor;
    return *this;
}

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

// Over the first `count` receivers.
void Classifier::measure(Candidate& candidate, std::span<const Receiver> receivers, std::size_t count) {
    const Node& node = hierarchy_of(solution_)[candidate.cut.sender];
    Rgb sum(0.0F);
    Vec3 mean(0.0F);
    std::array<Vec3, kMostPairs> vectors;
    for (std::size_t j = 0; j < count; ++j) {
        const IrradianceVector v = vector_at(candidate.cut.sender, receivers[j].position);
        vectors[j] = luminance(v.irradiance) * v.direction;
        sum += v.irradiance / static_cast<float>(count);
        mean += vectors[j] / static_cast<float>(count);
        candidate.largest = std::max(candidate.largest, luminance(v.irradiance));
    }
    const float size = length(mean), all = luminance(sum);
    candidate.irradiance = all > 0 ? size / all * sum : Rgb(0.0F);
    candidate.direction = size > 0 ? mean / size : Vec3(0, 0, 1);
    for (std::size_t j = 0; j < count; ++j) {
        candidate.spread = std::max(candidate.spread, 2 * length(vectors[j] - mean));
    }
    if (node.kind == NodeKind::kElement || is_cluster(node)) {
        for (const Receiver& receiver : receivers) {
            candidate.horizon = candidate.horizon || std::abs(dot(node.center - receiver.position, receiver.normal)) < node.radius;
        }
    }
}

void Classifier::add_rays(Candidate& candidate, std::span<const Receiver> receivers, std::uint32_t count) {
    const NodeId sender = candidate.cut.sender;
    const bool cluster = is_cluster(hierarchy_of(solution_)[sender]);
    candidate.first_ray = static_cast<std::uint32_t>(rays_.size());
    for (std::uint32_t k = 0; k < count; ++k) {
        const Receiver& receiver = receivers[k % receivers.size()];
        if (cluster) {
            const FacePoint& point = points_.of(sender)[k % kClusterPoints];
            const Vec3 to = point.position - receiver.position;
            if (dot(to, receiver.normal) > 0 && dot(to, point.normal) < 0) {
                rays_.push_back({receiver.position, to, 0, kAlmost});
            }
        } else {
            const SenderPoint point = sender_point(solution_, sender, k, receiver.position, receiver.normal);
            if (point.weight > 0) {
                rays_.push_back({receiver.position, point.direction, 0, point.infinite ? kInfinity : kAlmost});
            }
        }
    }
    candidate.ray_count = static_cast<std::uint32_t>(rays_.size()) - candidate.first_ray;
}

float Classifier::visibility_of(const Candidate& candidate, bool& mixed) const {
    if (candidate.ray_count == 0) {
        mixed = false;
        return candidate.cut.visibility;
    }
    std::uint32_t seen = 0;
    for (std::uint32_t k = candidate.first_ray; k < candidate.first_ray + candidate.ray_count; ++k) {
        seen += blocked_[k] ? 0 : 1;
    }
    mixed = (seen > 0 && seen < candidate.ray_count) || (candidate.cut.visibility > 0 && candidate.cut.visibility < 1);
    return static_cast<float>(seen) / static_cast<float>(candidate.ray_count);
}

void Classifier::add_near_light(std::span<const Receiver> receivers, Site& site) {
    if (cut_.near.empty()) {
        return;
    }
    // All directions from one receiver on each side that is seen.
    std::vector<const Receiver*> chosen{&receivers.front()};
    for (const Receiver& receiver : receivers) {
        if (dot(receiver.normal, chosen.front()->normal) < -0.2F) {
            chosen.push_back(&receiver);
            break;
        }
    }
    for (const Receiver* receiver : chosen) {
        near_.for_each_hit(cut_.near, receiver->position, receiver->normal, [&](Vec3 direction, Rgb radiosity) {
            add_beam(site.interpolated, 2.0F / kNearDirections * radiosity, direction);
        });
    }
    counts_.rays += chosen.size() * kNearDirections;
}

Site Classifier::classify(std::span<const Receiver> receivers) {
    receivers = receivers.first(std::min<std::size_t>(receivers.size(), kMostPairs));
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
    add_near_light(receivers, site);

    const float threshold = settings_.threshold * std::max(radiosity, settings_.least_radiosity);
    const float in_irradiance = threshold / std::max(reflectance, 0.02F);
    candidates_.clear();
    rays_.clear();
    float all = 0;
    for (const CutSender& sender : cut_.senders) {
        Candidate candidate;
        candidate.cut = sender;
        measure(candidate, receivers, 1);
        if (!(candidate.largest > 0) && receivers.size() > 1) {
            measure(candidate, receivers, receivers.size());
        }
        if (candidate.largest > 0) {
            all += luminance(candidate.irradiance);
            candidates_.push_back(candidate);
        }
    }
    for (Candidate& candidate : candidates_) {
        if (candidate.largest > kSettled * in_irradiance) {
            const float wanted = static_cast<float>(settings_.samples) * luminance(candidate.irradiance) / all;
            measure(candidate, receivers, receivers.size());
            add_rays(candidate, receivers,
                     std::clamp(static_cast<std::uint32_t>(wanted), kLeastPairs, kMostPairs));
        }
    }
    blocked_.resize(rays_.size());
    tracer_.occluded(rays_, blocked_, RayMask::kLight, Coherence::kIncoherent);
    for (const Candidate& candidate : candidates_) {
        bool mixed = false;
        const float visibility = visibility_of(candidate, mixed);
        const float brings = luminance(candidate.irradiance);
        SiteSender sender{candidate.cut.sender, false, false, 0, visibility, candidate.irradiance, candidate.direction};
        if (candidate.ray_count > 0 || candidate.largest > kSettled * in_irradiance) {
            const float form_factor_error = std::max(candidate.spread, candidate.horizon ? brings : 0.0F) * visibility;
            sender.resample_form_factor = form_factor_error > in_irradiance;
            sender.resample_visibility = mixed && brings > in_irradiance;
            sender.samples = std::max(kLeastSamples, static_cast<float>(settings_.samples) * brings / all);
        }
        if (sender.resample_form_factor || sender.resample_visibility) {
            counts_.both += sender.resample_form_factor && sender.resample_visibility;
            counts_.only_visibility += !sender.resample_form_factor;
            counts_.only_form_factor += !sender.resample_visibility;
            site.senders.push_back(sender);
        } else {
            add_beam(site.interpolated, visibility * candidate.irradiance, candidate.direction);
        }
    }
    std::sort(site.senders.begin(), site.senders.end(),
              [](const SiteSender& a, const SiteSender& b) { return a.sender < b.sender; });
    counts_ += {1, candidates_.size(), rays_.size(), 0, 0, 0};
    return site;
}

}  // namespace gg
