// The rays that points need that are shaded together.
#include <algorithm>
#include <bit>

#include "gather/merge_lists.h"
#include "gather/shade.h"

namespace gg {

namespace {

constexpr float kAlmost = 0.9999F;  // of the way to a sender
constexpr float kDoubt = 1e-4F;     // of a ray to a point that faces its receiver

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
        for (std::size_t k = 0; k < (fragments[p].known.sky ? 0 : fragments[p].count); ++k) {
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

// Form factors and rays of what is to be looked at anew.
void Shader::look_at_senders(std::span<const PlacedFragment> fragments) {
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
        group_.begin(sender);
        members_.clear();
        for (std::uint32_t p = 0; p < points_.size(); ++p) {
            if (heads_[p] == sender) {
                members_.push_back({p, next_[p]});
                move_to(p, next_[p] + 1);
            }
        }
        plan_samples(fragments);
        for (const Member& member : members_) {
            group_.add(points_[member.point].x, fragments[member.point].at.shading_normal, member.count() > 0);
        }
        work_out_form_factors();
        add_rays(fragments);
    });
}

void Shader::work_out_form_factors() {
    if (std::none_of(members_.begin(), members_.end(),
                     [&](const Member& member) { return tasks_[member.task].form_factor; })) {
        return;
    }
    group_.light(unoccluded_);
    for (std::size_t k = 0; k < members_.size(); ++k) {
        Task& task = tasks_[members_[k].task];
        if (task.form_factor) {
            task.unoccluded = unoccluded_[k];
            task.bright = luminance(task.unoccluded);
            ++points_[members_[k].point].taken.form_factors;
        }
    }
}

// Each member looks at a prefix of the sender's points, or at those that follow for other parts of a pixel. The last
// one counts by the fraction of the sample number, so that a number that changes from point to point changes nothing at
// once.
// Where all of the prefix turns away from a point that sees other parts of the sender, what the sites know counts
// instead.
// Members that look at more come first.
void Shader::plan_samples(std::span<const PlacedFragment> fragments) {
    for (Member& member : members_) {
        Task& task = tasks_[member.task];
        if (!task.visibility || task.known) {
            continue;
        }
        const float samples = std::clamp(task.samples * points_[member.point].share_of_samples, 1.0F,
                                         static_cast<float>(group_.most_points()));
        member.whole = static_cast<std::uint32_t>(samples);
        const float fraction = samples - static_cast<float>(member.whole);
        member.of_all =
            (1 - fraction) / static_cast<float>(member.whole) + fraction / static_cast<float>(member.whole + 1);
        member.of_last = fraction / static_cast<float>(member.whole + 1);
        // Few points of a prefix say little of a shadow with holes, and for all parts of a pixel the same.
        member.first = fragments[member.point].part * member.count() % (group_.most_points() - member.count() + 1);
        task.sent = kDoubt * group_.facing_weight(points_[member.point].x);
        task.seen = task.expected * task.sent;
    }
    // By classes alone, so that neighbours stay together.
    std::stable_sort(members_.begin(), members_.end(), [](const Member& a, const Member& b) {
        return std::bit_width(a.end()) > std::bit_width(b.end());
    });
}

// Rays of the members: all that go to the same point of the sender together.
void Shader::add_rays(std::span<const PlacedFragment> fragments) {
    std::uint32_t most = 0;
    for (const Member& member : members_) {
        most = std::max(most, member.end());
    }
    const float far = group_.infinite() ? kInfinity : kAlmost;
    for (const std::uint32_t i : group_.in_blocks(most, order_)) {
        const auto enough = std::partition_point(members_.begin(), members_.end(), [&](const Member& member) {
            return std::bit_width(member.end()) >= std::bit_width(i + 1);
        });
        const auto looking = static_cast<std::size_t>(enough - members_.begin());
        group_.see(i, looking, seen_);
        for (std::size_t k = 0; k < looking; ++k) {
            const Member& member = members_[k];
            const std::uint32_t own = i - member.first;  // beyond count() also where i is before the first
            if (own < member.count() && seen_.weight[k] > 0) {
                const Vec3 direction = seen_.direction(k);
                const float weight = seen_.weight[k] * (own < member.whole ? member.of_all : member.of_last);
                if (dot(direction, fragments[member.point].at.normal) > 0) {
                    add_ray({member.point, member.task, weight}, direction, far);
                } else {
                    tasks_[member.task].sent += weight;  // its own surface is in the way
                }
            }
        }
    }
}

}  // namespace gg
