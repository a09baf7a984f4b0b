// The rays that points need that are shaded together.
#include <algorithm>

#include "gather/merge_lists.h"
#include "gather/sender_light.h"
#include "gather/shade.h"

namespace gg {

namespace {

constexpr float kAlmost = 0.9999F;    // of the way to a sender
constexpr float kMostSamples = 1024;  // of an element or a lamp
constexpr float kDoubt = 1e-4F;       // of a ray to a point that faces its receiver

}  // namespace

void Shader::add_ray(RayOwner owner, Vec3 direction, float far) {
    // Written where they stay: put together elsewhere, copies would wait for their parts.
    Ray& ray = rays_.emplace_back();
    ray.origin = points_[owner.point].x;
    ray.direction = direction;
    ray.far = far;
    RayOwner& kept = owners_.emplace_back();
    kept.point = owner.point;
    kept.task = owner.task;
    kept.weight = owner.weight;
}

// Rays to the union of the sites' leaves of the sky.
void Shader::add_sky_rays(std::span<const PlacedFragment> fragments) {
    constexpr std::uint32_t kMost = SitePlace::kMost;
    next_.resize(kMost * fragments.size());
    heads_.assign(kMost * fragments.size(), kNone);
    const auto move_to = [&](std::size_t i, std::uint32_t place) {
        const auto& leaves = fragments[i / kMost].around[i % kMost].site->leaves;
        next_[i] = place;
        heads_[i] = place < leaves.size() ? leaves[place].id : kNone;
    };
    for (std::size_t p = 0; p < fragments.size(); ++p) {
        for (std::size_t k = 0; k < fragments[p].count; ++k) {
            move_to(kMost * p + k, 0);
        }
    }
    merge(heads_, [&](std::uint32_t id) {
        for (std::uint32_t p = 0; p < fragments.size(); ++p) {
            const Fragment& at = fragments[p].at;
            Vec3 direction(0.0F);
            float weight = 0;  // solid angle times the sites' weights, sr
            for (std::size_t i = kMost * p; i < kMost * p + fragments[p].count; ++i) {
                if (heads_[i] == id) {
                    const WeightedSite& weighted = fragments[p].around[i % kMost];
                    const SkyLeaf& leaf = weighted.site->leaves[next_[i]];
                    move_to(i, next_[i] + 1);
                    direction = leaf.direction;
                    weight += weighted.weight * leaf.solid_angle;
                }
            }
            const float cosine = dot(direction, at.shading_normal);
            if (weight > 0 && cosine > 0 && dot(direction, at.normal) > 0) {
                add_ray({p, kNone, weight * cosine}, direction, kInfinity);
            }
        }
    });
    sky_rays_ = rays_.size();
}

void Shader::add_sender_rays(std::span<const PlacedFragment> fragments) {
    next_.resize(points_.size());
    heads_.resize(points_.size());
    const auto move_to = [&](std::size_t p, std::uint32_t task) {
        next_[p] = task;
        heads_[p] = task < points_[p].end_task ? tasks_[task].sender : kNone;
    };
    for (std::size_t p = 0; p < points_.size(); ++p) {
        move_to(p, points_[p].first_task);
    }
    merge(heads_, [&](NodeId sender) {
        group_.clear();
        for (std::uint32_t p = 0; p < points_.size(); ++p) {
            if (heads_[p] == sender) {
                const std::uint32_t task = next_[p];
                move_to(p, task + 1);
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
// Where all of the prefix turns away from a point that sees other parts of the sender, what the sites know counts
// instead.
void Shader::add_rays(std::span<const PlacedFragment> fragments, NodeId sender) {
    const Node& node = hierarchy_of(solution_)[sender];
    const bool cluster = is_cluster(node);
    const auto targets = cluster ? cluster_points_.of(sender) : std::span<const FacePoint>();
    std::uint32_t most = 0;
    samplers_.clear();
    for (Member& member : group_) {
        const Fragment& at = fragments[member.point].at;
        const float samples = std::clamp(tasks_[member.task].samples * points_[member.point].share_of_samples, 1.0F,
                                         cluster ? static_cast<float>(kClusterPoints) : kMostSamples);
        member.whole = static_cast<std::uint32_t>(samples);
        const float fraction = samples - static_cast<float>(member.whole);
        member.of_all =
            (1 - fraction) / static_cast<float>(member.whole) + fraction / static_cast<float>(member.whole + 1);
        member.of_last = fraction / static_cast<float>(member.whole + 1);
        most = std::max(most, member.count());
        const Vec3 x = points_[member.point].x;
        float facing = 0;
        if (!cluster) {
            if (samplers_.empty()) {
                samplers_.emplace_back(solution_, sender, x, at.shading_normal);
            } else {
                samplers_.emplace_back(samplers_.front(), x, at.shading_normal);
            }
            facing = samplers_.back().facing_weight();
        } else if (!targets.empty()) {
            facing = luminance(targets.front().power) / (length_squared(node.center - x) + node.radius * node.radius);
        }
        Task& task = tasks_[member.task];
        task.sent = kDoubt * facing;
        task.seen = task.expected * task.sent;
    }
    const auto add = [&](const Member& member, std::uint32_t i, const SenderPoint& to) {
        const float weight = to.weight * (i < member.whole ? member.of_all : member.of_last);
        if (weight > 0 && dot(to.direction, fragments[member.point].at.normal) > 0) {
            add_ray({member.point, member.task, weight}, to.direction, to.infinite ? kInfinity : kAlmost);
        }
    };
    if (cluster) {
        for (std::uint32_t i = 0; i < most && !targets.empty(); ++i) {
            for (const Member& member : group_) {
                if (i < member.count()) {
                    const Vec3 to = targets[i].position - points_[member.point].x;
                    const Rgb light = irradiance_from(targets[i], 1, to, fragments[member.point].at.shading_normal,
                                                      0.5F * node.area / kClusterPoints);
                    add(member, i, {to, false, luminance(light)});
                }
            }
        }
    } else if (most > 0) {
        for (const std::uint32_t i : samplers_.front().in_blocks(most, order_)) {
            const SenderPlace place = samplers_.front().place(i);
            for (std::size_t k = 0; k < group_.size(); ++k) {
                if (i < group_[k].count()) {
                    add(group_[k], i, samplers_[k].point(place));
                }
            }
        }
    }
}

}  // namespace gg
