#include "gather/full_gather.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "gather/sender_light.h"
#include "trace/surface_point.h"

namespace gg {

namespace {

constexpr float kAlmost = 0.9999F;       // of the way to a sender
constexpr float kInsignificant = 1e-3F;  // share of all unoccluded light; less is found by rays in all directions
constexpr float kLeaf = 0.005F;          // irradiance of a part of the sky that has one ray, as a share of all
constexpr std::uint32_t kLeastRays = 4, kMostRays = 256;

}  // namespace

FullGather::FullGather(const Solution& solution, const NodeOrder& order, const ClusterPoints& points,
                       const RayTracer& tracer, int samples)
    : solution_(solution),
      order_(order),
      points_(points),
      tracer_(tracer),
      samples_(samples),
      cutter_(solution),
      surroundings_(solution, order, tracer),
      sky_(tracer, hierarchy_of(solution).scene().world) {}

// Rays from x to the sender's points.
void FullGather::add_rays(const Fragment& at, Task& task, std::uint32_t count) {
    const NodeId sender = cut_.senders[task.sender].sender;
    const Node& node = hierarchy_of(solution_)[sender];
    const Vec3 x = offset_origin(at.position, at.normal, 1);
    task.first_ray = static_cast<std::uint32_t>(rays_.size());
    if (is_cluster(node)) {
        const ClusterFaces& points = points_.of(sender);
        const std::uint32_t all = points.empty() ? 0 : std::min(count, kClusterPoints);
        const float share = static_cast<float>(kClusterPoints) / static_cast<float>(std::max(all, 1U));
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
        const SenderSampler sampler(solution_, sender, x, at.shading_normal);
        for (std::uint32_t i = 0; i < count; ++i) {
            const SenderPoint point = sampler.point(i);
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
        if (hierarchy[sender].kind == NodeKind::kSky) {
            continue;
        }
        task.light = unoccluded_irradiance(solution_, points_, sender, at.position, at.shading_normal);
        if (luminance(task.light) > 0) {
            all += luminance(task.light);
            tasks_.push_back(task);
        }
    }
    std::erase_if(tasks_, [&](const Task& task) {
        const bool lamp = hierarchy[cut_.senders[task.sender].sender].kind == NodeKind::kLamp;
        return !lamp && luminance(task.light) <= kInsignificant * all;
    });
    apart_.clear();
    for (Task& task : tasks_) {
        const NodeId sender = cut_.senders[task.sender].sender;
        const float share = luminance(task.light) / all;
        const auto count = static_cast<std::uint32_t>(std::lround(static_cast<float>(samples_) * share));
        add_rays(at, task, std::clamp(count, kLeastRays, kMostRays));
        if (hierarchy[sender].kind != NodeKind::kLamp) {
            apart_.push_back(order_.range(sender));
        }
    }
    std::sort(apart_.begin(), apart_.end());
}

// Of what is looked at one by one.
Rgb FullGather::light_of_tasks() const {
    Rgb sum(0.0F);
    for (const Task& task : tasks_) {
        if (is_cluster(hierarchy_of(solution_)[cut_.senders[task.sender].sender])) {
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
    return sum;
}

// Of all other surfaces, and of the sky.
Rgb FullGather::light_from_all_around(const Fragment& at, Vec3 x) {
    const Receiver receiver{x, at.normal, at.shading_normal, kNone, 0, 0};
    surroundings_.look_from(std::span(&receiver, 1));
    DirectionTable table;
    surroundings_.add_to(table, apart_, {});
    const Rgb world = hierarchy_of(solution_).scene().world;
    const TableCosines cosines(at.shading_normal);
    const float size = kLeaf * expected_ / std::max(luminance(world), 1e-20F);
    sky_.find(std::span(&receiver, 1), surroundings_, size, leaves_, table);
    Rgb sum = light_of(table, cosines);
    for (const SkyLeaf& leaf : leaves_) {
        if (receiver.faces(leaf.direction) && !tracer_.occluded({x, leaf.direction, 0, kInfinity}, RayMask::kLight)) {
            sum += leaf.solid_angle * dot(leaf.direction, at.shading_normal) * world;
        }
    }
    return sum;
}

Rgb FullGather::irradiance(const Fragment& at, float expected) {
    const NodeId place = place_at(solution_, at.hit.instance, at.hit.triangle, at.back, at.position);
    if (place == kNone) {
        return Rgb(0.0F);
    }
    Box bounds;
    bounds.extend(at.position);
    expected_ = expected;
    cutter_.build({std::span(&place, 1), bounds, expected}, cut_);
    plan(at);
    blocked_.resize(rays_.size());
    tracer_.occluded(rays_, blocked_, RayMask::kLight, Coherence::kCoherent);
    const std::size_t sky_rays = sky_.ray_count();
    const Rgb sum = light_of_tasks() + light_from_all_around(at, offset_origin(at.position, at.normal, 1));
    counts_.points += 1;
    counts_.senders += tasks_.size();
    counts_.form_factors += tasks_.size();
    counts_.visibility_rays += rays_.size() + leaves_.size() + sky_.ray_count() - sky_rays;
    counts_.near_rays += surroundings_.ray_count();
    return sum;
}

}  // namespace gg
