#include "gather/shade.h"

#include <algorithm>
#include <cmath>

#include "gather/sender_light.h"
#include "trace/surface_point.h"

namespace gg {

namespace {

constexpr float kAlmost = 0.9999F;        // of the way to a sender
constexpr float kShareOfSamples = 0.75F;  // power of a fragment's share by which its samples are fewer

}  // namespace

Shader::Shader(const Solution& solution, const NodeOrder& order, const ClusterPoints& points, const RayTracer& tracer)
    : solution_(solution), points_(points), tracer_(tracer), surroundings_(solution, order, tracer) {}

// The union of the sites' senders.
void Shader::plan(std::span<const WeightedSite> sites) {
    tasks_.clear();
    std::array<std::size_t, 8> next{};
    for (;;) {
        NodeId sender = kNone;
        for (std::size_t i = 0; i < sites.size(); ++i) {
            if (next[i] < sites[i].site->senders.size()) {
                sender = std::min(sender, sites[i].site->senders[next[i]].sender);
            }
        }
        if (sender == kNone) {
            return;
        }
        Task task;
        task.sender = sender;
        for (std::size_t i = 0; i < sites.size(); ++i) {
            const auto& senders = sites[i].site->senders;
            if (next[i] < senders.size() && senders[next[i]].sender == sender) {
                const SiteSender& model = senders[next[i]++];
                task.form_factor = task.form_factor || model.resample_form_factor;
                task.visibility = task.visibility || model.resample_visibility;
                task.samples += model.resample_visibility ? sites[i].weight * model.samples : 0.0F;
            }
        }
        tasks_.push_back(task);
    }
}

// The union of the sites' leaves of the sky; their rays come first.
void Shader::plan_sky(const Fragment& at, Vec3 x, std::span<const WeightedSite> sites) {
    sky_tasks_.clear();
    std::array<std::size_t, 8> next{};
    for (;;) {
        std::uint32_t id = kNone;
        for (std::size_t i = 0; i < sites.size(); ++i) {
            const auto& leaves = sites[i].site->leaves;
            id = next[i] < leaves.size() ? std::min(id, leaves[next[i]].id) : id;
        }
        if (id == kNone) {
            return;
        }
        SkyTask task;
        for (std::size_t i = 0; i < sites.size(); ++i) {
            const auto& leaves = sites[i].site->leaves;
            if (next[i] < leaves.size() && leaves[next[i]].id == id) {
                const SkyLeaf& leaf = leaves[next[i]++];
                task.direction = leaf.direction;
                task.weight += sites[i].weight * leaf.solid_angle;
            }
        }
        if (dot(task.direction, at.normal) > 0 && dot(task.direction, at.shading_normal) > 0) {
            sky_tasks_.push_back(task);
            rays_.push_back({x, task.direction, 0, kInfinity});
        }
    }
}

// Rays to a prefix of the sender's points; the last one counts by the fraction of the sample number, so that a number
// that changes from point to point changes nothing at once.
void Shader::add_rays(const Fragment& at, Vec3 x, Task& task) {
    const Node& node = hierarchy_of(solution_)[task.sender];
    task.first_ray = static_cast<std::uint32_t>(rays_.size());
    const auto add = [&](Vec3 to, bool infinite, float weight, float fraction) {
        if (weight > 0 && dot(to, at.normal) > 0) {
            rays_.push_back({x, to, 0, infinite ? kInfinity : kAlmost});
            weights_.push_back(weight * fraction);
        }
    };
    const float most = is_cluster(node) ? static_cast<float>(kClusterPoints) : 256.0F;
    // A pixel has about as many for all of its fragments as for one.
    const float samples = std::clamp(task.samples * std::pow(at.share, kShareOfSamples), 1.0F, most);
    const auto whole = static_cast<std::uint32_t>(samples);
    const float fraction = samples - static_cast<float>(whole);
    const float of_all = (1 - fraction) / static_cast<float>(whole) + fraction / static_cast<float>(whole + 1);
    const float of_last = fraction / static_cast<float>(whole + 1);
    const std::uint32_t count = whole + (fraction > 0 ? 1 : 0);
    const auto share = [&](std::uint32_t i) { return i < whole ? of_all : of_last; };
    if (is_cluster(node)) {
        for (std::uint32_t i = 0; i < count; ++i) {
            const FacePoint& point = points_.of(task.sender)[i];
            const Vec3 to = point.position - x;
            const Rgb light = irradiance_from(point, 1, to, at.shading_normal, 0.5F * node.area / kClusterPoints);
            add(to, false, luminance(light), share(i));
        }
    } else {
        const SenderSampler sampler(solution_, task.sender, x, at.shading_normal);
        for (const std::uint32_t i : sampler.in_blocks(count, order_)) {
            const SenderPoint point = sampler.point(i);
            add(point.direction, point.infinite, point.weight, share(i));
        }
    }
    task.ray_count = static_cast<std::uint32_t>(rays_.size()) - task.first_ray;
}

void Shader::weigh(Task& task) const {
    float seen = 0, sent = 0;
    for (std::uint32_t k = task.first_ray; k < task.first_ray + task.ray_count; ++k) {
        sent += weights_[k];
        seen += blocked_[k] ? 0.0F : weights_[k];
    }
    task.seen = sent > 0 ? seen / sent : 0;
}

// What surfaces close by bring in place of what tables say of their directions.
Rgb Shader::near_light(std::span<const WeightedSite> sites, const TableCosines& cosines) const {
    Rgb sum(0.0F);
    for (const Met& met : surroundings_.met()) {
        for (const WeightedSite& weighted : sites) {
            const Site& site = *weighted.site;
            const float near = site.near_cells[met.cell] ? site.reach.nearness(met.distance) : 0;
            if (near > 0) {
                const Rgb radiance = holds(site.apart, met.rank) ? Rgb(0.0F) : met.radiance;
                sum += weighted.weight * near * cosines.of[met.cell] *
                       (kTableSolidAngle * radiance - site.table.at(met.cell));
            }
        }
    }
    return sum;
}

Rgb Shader::irradiance(const Fragment& at, std::span<const WeightedSite> sites) {
    const Vec3 x = offset_origin(at.position, at.normal, 1);
    rays_.clear();
    plan_sky(at, x, sites);
    plan(sites);
    weights_.assign(rays_.size(), 0.0F);
    for (Task& task : tasks_) {
        if (task.form_factor) {
            const Node& node = hierarchy_of(solution_)[task.sender];
            if (is_cluster(node)) {
                for (const FacePoint& point : points_.of(task.sender)) {
                    task.unoccluded += irradiance_from(point, 1, point.position - x, at.shading_normal,
                                                       0.5F * node.area / kClusterPoints);
                }
            } else {
                task.unoccluded = unoccluded_irradiance(solution_, task.sender, x, at.shading_normal);
            }
            ++counts_.form_factors;
        }
        if (task.visibility) {
            add_rays(at, x, task);
        }
    }
    blocked_.resize(rays_.size());
    tracer_.occluded(rays_, blocked_, RayMask::kLight, Coherence::kCoherent);
    for (Task& task : tasks_) {
        if (task.visibility) {
            weigh(task);
        }
    }
    const TableCosines cosines(at.shading_normal);
    Rgb sum(0.0F);
    for (std::size_t k = 0; k < sky_tasks_.size(); ++k) {
        if (!blocked_[k]) {
            sum += sky_tasks_[k].weight * dot(sky_tasks_[k].direction, at.shading_normal) *
                   hierarchy_of(solution_).scene().world;
        }
    }
    float reach = 0;
    TableCellSet near;
    for (const WeightedSite& weighted : sites) {
        const Site& site = *weighted.site;
        reach = std::max(reach, site.reach.none);
        near |= site.near_cells;
        Rgb light = light_of(site.beams, at.shading_normal) + light_of(site.table, cosines);
        std::size_t task = 0;
        for (const SiteSender& model : site.senders) {
            while (tasks_[task].sender != model.sender) {
                ++task;
            }
            const Rgb unoccluded = model.resample_form_factor
                                       ? tasks_[task].unoccluded
                                       : std::max(0.0F, dot(at.shading_normal, model.direction)) * model.irradiance;
            light += (model.resample_visibility ? tasks_[task].seen : model.visibility) * unoccluded;
        }
        sum += weighted.weight * light;
    }
    if (near.any()) {
        surroundings_.look_near(x, at.normal, near, reach);
        sum += near_light(sites, cosines);
        counts_.near_rays += surroundings_.ray_count();
    }
    counts_.points += 1;
    counts_.senders += tasks_.size();
    counts_.visibility_rays += rays_.size();
    return sum;
}

}  // namespace gg
