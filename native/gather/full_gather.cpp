#include "gather/full_gather.h"

#include <algorithm>
#include <cmath>

#include "gather/sender_light.h"
#include "trace/surface_point.h"

namespace gg {

namespace {

constexpr float kAlmost = 0.9999F;       // of the way to a sender
constexpr float kInsignificant = 1e-3F;  // share of all unoccluded light; from there on what links know is enough
constexpr std::uint32_t kLeastRays = 4, kMostRays = 256;

}  // namespace

FullGather::FullGather(const Solution& solution, const ClusterPoints& points, const RayTracer& tracer, int samples)
    : solution_(solution),
      points_(points),
      tracer_(tracer),
      samples_(samples),
      cutter_(solution),
      near_(solution, tracer) {}

// Rays from x to the sender's points.
void FullGather::add_rays(const Fragment& at, Task& task, std::uint32_t count) {
    const NodeId sender = cut_.senders[task.sender].sender;
    const Node& node = hierarchy_of(solution_)[sender];
    const Vec3 x = offset_origin(at.position, at.normal, 1);
    task.first_ray = static_cast<std::uint32_t>(rays_.size());
    if (is_cluster(node)) {
        const auto points = points_.of(sender);
        const std::uint32_t all = std::min(count, static_cast<std::uint32_t>(points.size()));
        const float share = static_cast<float>(points.size()) / static_cast<float>(std::max(all, 1U));
        for (std::uint32_t i = 0; i < all; ++i) {
            const Vec3 to = points[i].position - x;
            const Rgb light =
                irradiance_from(points[i], share, to, at.shading_normal, 0.5F * node.area / static_cast<float>(all));
            if (luminance(light) > 0 && dot(to, at.normal) > 0) {
                rays_.push_back({x, to, 0, kAlmost});
                weights_.push_back(1);
                ray_light_.push_back(light);
            }
        }
    } else {
        const SenderSampler sampler(solution_, sender, x);
        for (std::uint32_t i = 0; i < count; ++i) {
            const SenderPoint point = sampler.point(i, at.shading_normal);
            if (point.weight > 0) {
                rays_.push_back({x, point.direction, 0, point.infinite ? kInfinity : kAlmost});
                weights_.push_back(point.weight);
                ray_light_.push_back(Rgb(0.0F));
            }
        }
    }
    task.ray_count = static_cast<std::uint32_t>(rays_.size()) - task.first_ray;
}

void FullGather::plan(const Fragment& at) {
    const Hierarchy& hierarchy = hierarchy_of(solution_);
    tasks_.clear();
    rays_.clear();
    weights_.clear();
    ray_light_.clear();
    float all = 0;
    for (std::size_t i = 0; i < cut_.senders.size(); ++i) {
        const NodeId sender = cut_.senders[i].sender;
        Task task{i, Rgb(0.0F), 0, 0};
        if (is_cluster(hierarchy[sender])) {
            const auto points = points_.of(sender);
            for (const FacePoint& point : points) {
                task.light += irradiance_from(point, 1, point.position - at.position, at.shading_normal,
                                              0.5F * hierarchy[sender].area / static_cast<float>(points.size()));
            }
        } else {
            task.light = unoccluded_irradiance(solution_, sender, at.position, at.shading_normal);
        }
        if (luminance(task.light) > 0) {
            all += luminance(task.light);
            tasks_.push_back(task);
        }
    }
    for (Task& task : tasks_) {
        const float share = luminance(task.light) / all;
        if (share > kInsignificant) {
            const auto count = static_cast<std::uint32_t>(std::lround(static_cast<float>(samples_) * share));
            add_rays(at, task, std::clamp(count, kLeastRays, kMostRays));
        }
    }
}

Rgb FullGather::irradiance(const Fragment& at, float expected) {
    const NodeId place = place_at(solution_, at.hit.instance, at.hit.triangle, at.back, at.position);
    if (place == kNone) {
        return Rgb(0.0F);
    }
    Box bounds;
    bounds.extend(at.position);
    cutter_.build({std::span(&place, 1), bounds, expected}, cut_);
    plan(at);
    blocked_.resize(rays_.size());
    tracer_.occluded(rays_, blocked_, RayMask::kLight, Coherence::kCoherent);
    Rgb sum(0.0F);
    const NearOrigin origin{offset_origin(at.position, at.normal, 1), at.normal};
    if (!cut_.near.empty()) {
        near_.for_each_hit(cut_.near, std::span(&origin, 1), [&](Vec3 direction, Rgb irradiance) {
            sum += std::max(0.0F, dot(at.shading_normal, direction)) * irradiance;
        });
    }
    for (const Task& task : tasks_) {
        const CutSender& sender = cut_.senders[task.sender];
        if (task.ray_count == 0) {
            sum += sender.visibility * task.light;
        } else if (is_cluster(hierarchy_of(solution_)[sender.sender])) {
            for (std::uint32_t k = task.first_ray; k < task.first_ray + task.ray_count; ++k) {
                sum += blocked_[k] ? Rgb(0.0F) : ray_light_[k];
            }
        } else {
            float seen = 0, sent = 0;
            for (std::uint32_t k = task.first_ray; k < task.first_ray + task.ray_count; ++k) {
                sent += weights_[k];
                seen += blocked_[k] ? 0.0F : weights_[k];
            }
            sum += seen / std::max(sent, 1e-30F) * task.light;
        }
    }
    counts_.points += 1;
    counts_.senders += tasks_.size();
    counts_.visibility_rays += rays_.size();
    counts_.near_rays += cut_.near.empty() ? 0 : kNearDirections;
    return sum;
}

}  // namespace gg
