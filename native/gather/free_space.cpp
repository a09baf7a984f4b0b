#include "gather/free_space.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "gather/sender_light.h"
#include "gather/sender_place.h"

namespace gg {

namespace {

constexpr float kAlmost = 0.9999F;  // of the way to a sender
constexpr float kApart = 1e-4F;     // hits closer to one another are one, share of the distance
constexpr int kMostFaces = 2;       // that a ray may meet
constexpr std::uint32_t kFewestPoints = 2;

}  // namespace

void HitCounter::count(std::span<const Ray> rays, std::vector<std::uint8_t>& blocked) {
    blocked.assign(rays.size(), 0);
    faces_.assign(rays.size(), 0);
    rest_.assign(rays.begin(), rays.end());
    rays_.resize(rays.size());
    for (std::uint32_t i = 0; i < rays.size(); ++i) {
        rays_[i] = i;
    }
    while (!rest_.empty()) {
        hits_.resize(rest_.size());
        tracer_.closest_hits(rest_, hits_, RayMask::kLight, Coherence::kIncoherent);
        std::size_t kept = 0;
        for (std::size_t k = 0; k < rest_.size(); ++k) {
            const Hit& hit = hits_[k];
            if (hit.missed()) {
                continue;
            }
            const std::uint32_t i = rays_[k];
            faces_[i] += scene_.sides_of(hit.instance, hit.triangle) == Sides::kBoth ? kMostFaces : 1;
            if (faces_[i] > kMostFaces) {
                blocked[i] = 1;
                continue;
            }
            rest_[kept] = rest_[k];
            rest_[kept].near = hit.distance * (1 + kApart);
            rays_[kept++] = i;
        }
        rest_.resize(kept);
        rays_.resize(kept);
    }
}

FreeSpaceClassifier::FreeSpaceClassifier(const Solution& solution, const NodeOrder& order, const ClusterPoints& points,
                                         const RayTracer& tracer, const ClassifySettings& settings)
    : solution_(solution),
      order_(order),
      cluster_points_(points),
      settings_(settings),
      cutter_(solution),
      surroundings_(solution, order, tracer),
      sky_(tracer, hierarchy_of(solution).scene().world),
      hit_counter_(hierarchy_of(solution).scene(), tracer) {}

// Importance is unoccluded irradiance, since senders that are hidden in part should not have fewer samples.
void FreeSpaceClassifier::list_candidates(const FreeSpace& space) {
    candidates_.clear();
    float all = 0;
    for (const CutSender& sender : cut_.senders) {
        const NodeKind kind = hierarchy_of(solution_)[sender.sender].kind;
        if (kind == NodeKind::kSky || !(sender.visibility > 0)) {
            continue;
        }
        Candidate candidate;
        candidate.sender = sender.sender;
        candidate.occluder = sender.occluder;
        candidate.importance =
            luminance(irradiance_vector(solution_, cluster_points_, sender.sender, space.vertex).irradiance);
        all += candidate.importance;
        candidates_.push_back(candidate);
    }
    for (Candidate& candidate : candidates_) {
        candidate.importance /= std::max(all, 1e-30F);
    }
}

// The kernel of the form factor, without the receiver's cosine, and rays for the visibility.
void FreeSpaceClassifier::sample(Candidate& candidate, std::span<const Vec3> points) {
    const Node& node = hierarchy_of(solution_)[candidate.sender];
    const auto wanted = static_cast<std::uint32_t>(static_cast<float>(settings_.samples) * candidate.importance);
    const std::uint32_t count =
        std::clamp(wanted, kFewestPoints, std::min(kMostPoints, static_cast<std::uint32_t>(points.size())));
    const auto share = 1 / static_cast<float>(count);
    candidate.first_ray = static_cast<std::uint32_t>(rays_.size());
    candidate.least = kInfinity;
    Rgb sum(0.0F);
    Vec3 mean(0.0F);
    for (std::uint32_t i = 0; i < count; ++i) {
        const IrradianceVector v = irradiance_vector(solution_, cluster_points_, candidate.sender, points[i]);
        const float size = luminance(v.irradiance);
        candidate.least = std::min(candidate.least, size);
        candidate.most = std::max(candidate.most, size);
        sum += share * v.irradiance;
        mean += share * size * v.direction;
        if (is_cluster(node)) {
            const ClusterFaces& faces = cluster_points_.of(candidate.sender);
            if (!faces.empty()) {
                rays_.push_back({points[i], faces[i % kClusterPoints].position - points[i], 0, kAlmost});
            }
        } else if (size > 0) {
            const SenderPoint to = SenderSampler(solution_, candidate.sender, points[i], v.direction).point(i);
            rays_.push_back({points[i], to.direction, 0, to.infinite ? kInfinity : kAlmost});
        }
    }
    candidate.ray_count = static_cast<std::uint32_t>(rays_.size()) - candidate.first_ray;
    candidate.irradiance = sum;
    candidate.direction = length(mean) > 0 ? normalize(mean) : Vec3(0, 0, 1);
}

// Clusters around the vertex itself: their light by one ray in each of 128 directions, for interpolation; without what
// of them is a sender by itself.
void FreeSpaceClassifier::add_self_links(Vec3 vertex, DirectionTable& table) {
    self_.clear();
    linked_.clear();
    for (const NodeId cluster : cut_.near) {
        self_.push_back(order_.range(cluster));
    }
    for (const CutSender& sender : cut_.senders) {
        linked_.push_back(order_.range(sender.sender));
    }
    std::sort(self_.begin(), self_.end());
    std::sort(linked_.begin(), linked_.end());
    std::array<NearPoint, 2> both{NearPoint{vertex, {0, 0, 1}, {}, kInfinity}, {vertex, {0, 0, -1}, {}, kInfinity}};
    both[0].cells.set();
    both[1].cells.set();
    surroundings_.look_near(both);
    for (const Met& met : surroundings_.met()) {
        if (holds(self_, met.rank) && !holds(linked_, met.rank)) {
            table.add(met.cell, kTableSolidAngle * met.radiance);
        }
    }
    counts_.near_rays += surroundings_.ray_count();
}

Site FreeSpaceClassifier::classify(const FreeSpace& space, float threshold) {
    Box bounds;
    for (const Vec3 point : space.points) {
        bounds.extend(point);
    }
    places_.clear();
    for (const Receiver& receiver : space.receivers) {
        if (receiver.place != kNone) {
            places_.push_back(receiver.place);
        }
    }
    const ReceiverMeans means = means_of(space.receivers);
    const bool looked_at = threshold > 0;
    if (!looked_at) {
        threshold = threshold_at(settings_, means.radiosity);
    }
    cutter_.build({places_, bounds, means.irradiance}, cut_);
    rays_.clear();
    list_candidates(space);
    for (Candidate& candidate : candidates_) {
        sample(candidate, space.points);
    }
    hit_counter_.count(rays_, blocked_);
    Site site;
    for (const Candidate& candidate : candidates_) {
        const auto blocked = std::count(blocked_.begin() + candidate.first_ray,
                                        blocked_.begin() + candidate.first_ray + candidate.ray_count, 1);
        const float visibility =
            candidate.ray_count > 0 ? 1 - static_cast<float>(blocked) / static_cast<float>(candidate.ray_count) : 0;
        const float form_factor_error = means.reflectance * (candidate.most - candidate.least) * visibility;  // [eq. 2]
        const float visibility_error =
            visibility > 0 && visibility < 1 ? means.reflectance * luminance(candidate.irradiance) : 0.0F;  // [eq. 3]
        const bool form_factor = form_factor_error > threshold, seen = visibility_error > threshold;
        counts_.both += form_factor && seen;
        counts_.only_form_factor += form_factor && !seen;
        counts_.only_visibility += seen && !form_factor;
        if (form_factor || seen) {
            const Shadow shadow = shadow_on(means, hierarchy_of(solution_), candidate.sender, candidate.direction,
                                            luminance(candidate.irradiance), candidate.occluder);
            const float samples = looked_at ? shadow_samples(shadow, threshold)
                                            : static_cast<float>(settings_.samples) * candidate.importance;
            site.senders.push_back({candidate.sender, form_factor, seen, std::max(samples, 1.0F), visibility,
                                    candidate.irradiance, candidate.direction,
                                    is_soft(hierarchy_of(solution_)[candidate.sender])});
        } else if (visibility > 0) {
            site.beams.push_back({candidate.direction, visibility * candidate.irradiance});
        }
    }
    std::sort(site.senders.begin(), site.senders.end(),
              [](const SiteSender& a, const SiteSender& b) { return a.sender < b.sender; });
    add_self_links(space.vertex, site.table);
    const float world = luminance(hierarchy_of(solution_).scene().world);
    if (world > 0) {
        surroundings_.look_from(space.receivers);
        counts_.near_rays += surroundings_.ray_count();
        const std::size_t sky_rays = sky_.ray_count();
        sky_.find(space.receivers, surroundings_, settings_.sky_leaf * means.irradiance / world, site.leaves,
                  site.table);
        counts_.visibility_rays += sky_.ray_count() - sky_rays;
    }
    counts_.points += 1;
    counts_.senders += cut_.senders.size();
    counts_.visibility_rays += rays_.size();
    return site;
}

}  // namespace gg
