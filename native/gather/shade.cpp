#include "gather/shade.h"

#include <algorithm>
#include <cmath>

#include "gather/sender_light.h"
#include "trace/surface_point.h"

namespace gg {

namespace {

constexpr float kAlmost = 0.9999F;        // of the way to a sender
constexpr float kShareOfSamples = 0.75F;  // power of a fragment's share by which its samples are fewer
constexpr float kMostSamples = 1024;      // of an element or a lamp

// Calls body(key) for every key of several ascending lists, in ascending order; body has to move on in the lists
// that stand there.
template <typename KeyAt, typename Body>
void merge(std::size_t lists, const KeyAt& key_at, const Body& body) {
    for (;;) {
        std::uint32_t least = kNone;
        for (std::size_t i = 0; i < lists; ++i) {
            least = std::min(least, key_at(i));
        }
        if (least == kNone) {
            return;
        }
        body(least);
    }
}

}  // namespace

Shader::Shader(const Solution& solution, const NodeOrder& order, const ClusterPoints& points, const RayTracer& tracer)
    : solution_(solution), cluster_points_(points), tracer_(tracer), surroundings_(solution, order, tracer) {}

// Adds the union of the sites' senders to the tasks.
void Shader::plan(std::span<const WeightedSite> sites) {
    std::array<std::size_t, 4> next{};
    const auto sender_at = [&](std::size_t i) {
        const auto& senders = sites[i].site->senders;
        return next[i] < senders.size() ? senders[next[i]].sender : kNone;
    };
    merge(sites.size(), sender_at, [&](NodeId sender) {
        Task task;
        task.sender = sender;
        for (std::size_t i = 0; i < sites.size(); ++i) {
            if (sender_at(i) == sender) {
                const SiteSender& model = sites[i].site->senders[next[i]++];
                task.form_factor = task.form_factor || model.resample_form_factor;
                task.visibility = task.visibility || model.resample_visibility;
                task.samples += model.resample_visibility ? sites[i].weight * model.samples : 0.0F;
            }
        }
        tasks_.push_back(task);
    });
}

// Rays to the union of the sites' leaves of the sky.
void Shader::add_sky_rays(std::span<const PlacedFragment> fragments) {
    next_.assign(4 * fragments.size(), 0);
    const auto leaf_at = [&](std::size_t i) {
        const PlacedFragment& fragment = fragments[i / 4];
        if (i % 4 >= fragment.count) {
            return kNone;
        }
        const auto& leaves = fragment.around[i % 4].site->leaves;
        return next_[i] < leaves.size() ? leaves[next_[i]].id : kNone;
    };
    merge(next_.size(), leaf_at, [&](std::uint32_t id) {
        for (std::uint32_t p = 0; p < fragments.size(); ++p) {
            const Fragment& at = fragments[p].at;
            Vec3 direction(0.0F);
            float weight = 0;  // solid angle times the sites' weights, sr
            for (std::size_t i = 4 * p; i < 4 * p + 4; ++i) {
                if (leaf_at(i) == id) {
                    const WeightedSite& weighted = fragments[p].around[i % 4];
                    const SkyLeaf& leaf = weighted.site->leaves[next_[i]++];
                    direction = leaf.direction;
                    weight += weighted.weight * leaf.solid_angle;
                }
            }
            const float cosine = dot(direction, at.shading_normal);
            if (weight > 0 && cosine > 0 && dot(direction, at.normal) > 0) {
                rays_.push_back({points_[p].x, direction, 0, kInfinity});
                owners_.push_back({p, kNone, weight * cosine});
            }
        }
    });
    sky_rays_ = rays_.size();
}

void Shader::add_sender_rays(std::span<const PlacedFragment> fragments) {
    next_.clear();
    for (const Point& point : points_) {
        next_.push_back(point.first_task);
    }
    const auto sender_at = [&](std::size_t p) {
        return next_[p] < points_[p].end_task ? tasks_[next_[p]].sender : kNone;
    };
    merge(points_.size(), sender_at, [&](NodeId sender) {
        group_.clear();
        for (std::uint32_t p = 0; p < points_.size(); ++p) {
            if (sender_at(p) == sender) {
                const std::uint32_t task = next_[p]++;
                if (tasks_[task].visibility) {
                    group_.push_back({p, task});
                }
            }
        }
        add_rays(fragments, sender);
    });
}

// Rays of a group's points to a prefix of a sender's points: all that go to the same one together. The last one counts
// by the fraction of the sample number, so that a number that changes from point to point changes nothing at once.
void Shader::add_rays(std::span<const PlacedFragment> fragments, NodeId sender) {
    const Node& node = hierarchy_of(solution_)[sender];
    const bool cluster = is_cluster(node);
    std::uint32_t most = 0;
    samplers_.clear();
    for (Member& member : group_) {
        const Fragment& at = fragments[member.point].at;
        // A pixel has about as many for all of its fragments as for one.
        const float samples = std::clamp(tasks_[member.task].samples * std::pow(at.share, kShareOfSamples), 1.0F,
                                         cluster ? static_cast<float>(kClusterPoints) : kMostSamples);
        member.whole = static_cast<std::uint32_t>(samples);
        const float fraction = samples - static_cast<float>(member.whole);
        member.of_all =
            (1 - fraction) / static_cast<float>(member.whole) + fraction / static_cast<float>(member.whole + 1);
        member.of_last = fraction / static_cast<float>(member.whole + 1);
        most = std::max(most, member.count());
        if (!cluster) {
            samplers_.emplace_back(solution_, sender, points_[member.point].x, at.shading_normal);
        }
    }
    const auto add = [&](const Member& member, std::uint32_t i, const SenderPoint& to) {
        const float weight = to.weight * (i < member.whole ? member.of_all : member.of_last);
        if (weight > 0 && dot(to.direction, fragments[member.point].at.normal) > 0) {
            rays_.push_back({points_[member.point].x, to.direction, 0, to.infinite ? kInfinity : kAlmost});
            owners_.push_back({member.point, member.task, weight});
        }
    };
    if (cluster) {
        const auto points = cluster_points_.of(sender);
        for (std::uint32_t i = 0; i < most && !points.empty(); ++i) {
            for (const Member& member : group_) {
                if (i < member.count()) {
                    const Vec3 to = points[i].position - points_[member.point].x;
                    const Rgb light = irradiance_from(points[i], 1, to, fragments[member.point].at.shading_normal,
                                                      0.5F * node.area / kClusterPoints);
                    add(member, i, {to, false, luminance(light)});
                }
            }
        }
    } else if (most > 0) {
        for (const std::uint32_t i : samplers_.front().in_blocks(most, order_)) {
            for (std::size_t k = 0; k < group_.size(); ++k) {
                if (i < group_[k].count()) {
                    add(group_[k], i, samplers_[k].point(i));
                }
            }
        }
    }
}

void Shader::work_out_form_factors(const PlacedFragment& fragment, Point& point) {
    for (Task& task : std::span(tasks_).subspan(point.first_task, point.end_task - point.first_task)) {
        if (!task.form_factor) {
            continue;
        }
        const Node& node = hierarchy_of(solution_)[task.sender];
        if (is_cluster(node)) {
            for (const FacePoint& face : cluster_points_.of(task.sender)) {
                task.unoccluded += irradiance_from(face, 1, face.position - point.x, fragment.at.shading_normal,
                                                   0.5F * node.area / kClusterPoints);
            }
        } else {
            task.unoccluded = unoccluded_irradiance(solution_, task.sender, point.x, fragment.at.shading_normal);
        }
        ++point.taken.form_factors;
    }
}

void Shader::trace() {
    blocked_.resize(rays_.size());
    tracer_.occluded(rays_, blocked_, RayMask::kLight, Coherence::kCoherent);
    const Rgb world = hierarchy_of(solution_).scene().world;
    for (const RayOwner& owner : owners_) {
        ++points_[owner.point].taken.visibility_rays;
    }
    for (std::size_t k = 0; k < sky_rays_; ++k) {
        points_[owners_[k].point].light += blocked_[k] ? Rgb(0.0F) : owners_[k].weight * world;
    }
    for (std::size_t k = sky_rays_; k < rays_.size(); ++k) {
        Task& task = tasks_[owners_[k].task];
        task.sent += owners_[k].weight;
        task.seen += blocked_[k] ? 0.0F : owners_[k].weight;
    }
}

Rgb Shader::light_of_models(const PlacedFragment& fragment, const Point& point, const TableCosines& cosines) const {
    const Vec3 normal = fragment.at.shading_normal;
    Rgb sum(0.0F);
    for (const WeightedSite& weighted : fragment.sites()) {
        const Site& site = *weighted.site;
        Rgb light = light_of(site.beams, normal) + light_of(site.table, cosines);
        std::size_t k = point.first_task;
        for (const SiteSender& model : site.senders) {
            while (tasks_[k].sender != model.sender) {
                ++k;
            }
            const Task& task = tasks_[k];
            const Rgb unoccluded = model.resample_form_factor
                                       ? task.unoccluded
                                       : std::max(0.0F, dot(normal, model.direction)) * model.irradiance;
            light += (model.resample_visibility ? task.visible() : model.visibility) * unoccluded;
        }
        sum += weighted.weight * light;
    }
    return sum;
}

// What surfaces close by bring in place of what tables say of their directions.
void Shader::add_near_light(std::span<const PlacedFragment> fragments) {
    near_.clear();
    for (std::size_t p = 0; p < fragments.size(); ++p) {
        near_.push_back({points_[p].x, fragments[p].at.normal, {}, 0});
        for (const WeightedSite& weighted : fragments[p].sites()) {
            near_[p].reach = std::max(near_[p].reach, weighted.site->reach.none);
            near_[p].cells |= weighted.site->near_cells;
        }
    }
    surroundings_.look_near(near_);
    counts_.near_rays += surroundings_.ray_count();
    for (const RayOrigin& origin : surroundings_.origins()) {
        ++points_[origin.point].taken.visibility_rays;
    }
    for (const Met& met : surroundings_.met()) {
        for (const WeightedSite& weighted : fragments[met.point].sites()) {
            const Site& site = *weighted.site;
            const float near = site.near_cells[met.cell] ? site.reach.nearness(met.distance) : 0;
            if (near > 0) {
                const Rgb radiance = holds(site.apart, met.rank) ? Rgb(0.0F) : met.radiance;
                points_[met.point].light += weighted.weight * near * cosines_[met.point].of[met.cell] *
                                            (kTableSolidAngle * radiance - site.table.at(met.cell));
            }
        }
    }
}

void Shader::shade(std::span<const PlacedFragment> fragments, std::span<Rgb> light, std::span<PointCounts> taken) {
    points_.clear();
    tasks_.clear();
    cosines_.clear();
    rays_.clear();
    owners_.clear();
    for (const PlacedFragment& fragment : fragments) {
        Point point;
        point.x = offset_origin(fragment.at.position, fragment.at.normal, 1);
        point.first_task = static_cast<std::uint32_t>(tasks_.size());
        plan(fragment.sites());
        point.end_task = static_cast<std::uint32_t>(tasks_.size());
        point.taken.senders = point.end_task - point.first_task;
        work_out_form_factors(fragment, point);
        points_.push_back(point);
        cosines_.emplace_back(fragment.at.shading_normal);
    }
    add_sky_rays(fragments);
    add_sender_rays(fragments);
    trace();
    for (std::size_t p = 0; p < fragments.size(); ++p) {
        points_[p].light += light_of_models(fragments[p], points_[p], cosines_[p]);
    }
    add_near_light(fragments);
    for (std::size_t p = 0; p < fragments.size(); ++p) {
        light[p] = points_[p].light;
        taken[p] = points_[p].taken;
        counts_.form_factors += taken[p].form_factors;
    }
    counts_.points += fragments.size();
    counts_.senders += tasks_.size();
    counts_.visibility_rays += rays_.size();
}

}  // namespace gg
