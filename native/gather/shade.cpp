#include "gather/shade.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "gather/merge_lists.h"
#include "trace/surface_point.h"

namespace gg {

namespace {

constexpr float kShareOfSamples = 0.75F;  // power of a fragment's share by which its samples are fewer
constexpr float kSmallShare = 0.3F;       // of a pixel, for which one of two directions finds well enough what is near

}  // namespace

Shader::Shader(const Solution& solution, const NodeOrder& order, const ClusterPoints& points, const RayTracer& tracer)
    : solution_(solution), tracer_(tracer), surroundings_(solution, order, tracer), group_(solution, points) {}

// Adds the union of the sites' senders to the tasks, but for what is known.
void Shader::plan(const PlacedFragment& fragment) {
    const auto sites = fragment.sites();
    std::array<std::uint32_t, SitePlace::kMost> next{};
    std::array<std::uint32_t, SitePlace::kMost> heads{};
    const auto move_to = [&](std::size_t i, std::uint32_t place) {
        const auto& senders = sites[i].site->senders;
        while (fragment.known.soft && place < senders.size() && senders[place].soft) {
            ++place;
        }
        next[i] = place;
        heads[i] = place < senders.size() ? senders[place].sender : kNone;
    };
    for (std::size_t i = 0; i < sites.size(); ++i) {
        move_to(i, 0);
    }
    auto known = fragment.known.glowing.begin();
    merge(std::span(heads).first(sites.size()), [&](NodeId sender) {
        Task task;
        task.sender = sender;
        float resampled = 0;  // weight of the sites that do
        for (std::size_t i = 0; i < sites.size(); ++i) {
            if (heads[i] == sender) {
                const SiteSender& model = sites[i].site->senders[next[i]];
                move_to(i, next[i] + 1);
                task.soft = model.soft;
                task.form_factor = task.form_factor || model.resample_form_factor;
                task.visibility = task.visibility || model.resample_visibility;
                const float weight = model.resample_visibility ? sites[i].weight : 0.0F;
                task.samples += weight * model.samples;
                task.expected += weight * model.visibility;
                const float cosine = std::max(0.0F, dot(fragment.at.shading_normal, model.direction));
                task.bright = std::max(task.bright, cosine * luminance(model.irradiance));
                resampled += weight;
            }
        }
        task.expected /= std::max(resampled, 1e-30F);
        while (known != fragment.known.glowing.end() && known->sender < sender) {
            ++known;
        }
        if (task.visibility && known != fragment.known.glowing.end() && known->sender == sender) {
            task.known = true;
            task.expected = known->visibility;
        }
        tasks_.push_back(task);
    });
}

void Shader::trace() {
    const auto start = std::chrono::steady_clock::now();
    blocked_.resize(rays_.size());
    // Those to the sky are parallel, and most reach it. Those to senders part.
    const auto trace = [&](std::size_t begin, std::size_t end, Coherence coherence) {
        tracer_.occluded(std::span(rays_).subspan(begin, end - begin), std::span(blocked_).subspan(begin, end - begin),
                         RayMask::kLight, coherence);
    };
    trace(0, sky_rays_, Coherence::kCoherent);
    trace(sky_rays_, rays_.size(), Coherence::kIncoherent);
    counts_.visibility_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const Rgb world = hierarchy_of(solution_).scene().world;
    for (const RayOwner& owner : owners_) {
        ++points_[owner.point].taken.visibility_rays;
    }
    for (std::size_t k = 0; k < sky_rays_; ++k) {
        points_[owners_[k].point].light.sky += blocked_[k] ? Rgb(0.0F) : owners_[k].weight * world;
    }
    for (std::size_t k = sky_rays_; k < rays_.size(); ++k) {
        Task& task = tasks_[owners_[k].task];
        task.sent += owners_[k].weight;
        task.seen += blocked_[k] ? 0.0F : owners_[k].weight;
    }
}

// Without what is near.
PointLight Shader::light_of_models(const PlacedFragment& fragment, const Point& point,
                                   const TableCosines& cosines) const {
    const Vec3 normal = fragment.at.shading_normal;
    PointLight sum;
    for (const WeightedSite& weighted : fragment.sites()) {
        const Site& site = *weighted.site;
        Rgb light = light_of(site.beams, normal) + light_of(site.table, cosines);
        Rgb soft(0.0F);
        std::size_t k = point.first_task;
        for (const SiteSender& model : site.senders) {
            if (model.soft && fragment.known.soft) {
                continue;
            }
            while (tasks_[k].sender != model.sender) {
                ++k;
            }
            const Task& task = tasks_[k];
            const Rgb unoccluded = model.resample_form_factor
                                       ? task.unoccluded
                                       : std::max(0.0F, dot(normal, model.direction)) * model.irradiance;
            (model.soft ? soft : light) += (model.resample_visibility ? task.visible() : model.visibility) * unoccluded;
        }
        sum.all += weighted.weight * light;
        sum.soft += weighted.weight * soft;
    }
    return sum;
}

void Shader::add_near_light(std::span<const PlacedFragment> fragments) {
    near_.clear();
    for (std::size_t p = 0; p < fragments.size(); ++p) {
        near_.push_back({points_[p].x, fragments[p].at.normal, {}, 0});
        if (fragments[p].known.soft) {
            points_[p].light.soft = *fragments[p].known.soft;
            continue;
        }
        const bool small = fragments[p].at.share < kSmallShare;
        for (const WeightedSite& weighted : fragments[p].sites()) {
            const Site& site = *weighted.site;
            near_[p].reach = std::max(near_[p].reach, site.reach.none);
            near_[p].cells |= small ? site.near_cells : site.near_cells & ~site.close_cells;
            near_[p].close_cells |= small ? TableCellSet() : site.close_cells;
        }
        if (small) {
            near_[p].cells = one_of_partners(near_[p].cells);
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
            const float near = weighted.weight * site.reach.nearness(met.distance);
            if (!(near > 0)) {
                continue;
            }
            const Rgb light = holds(site.apart, met.rank) ? Rgb(0.0F) : kTableSolidAngle * met.radiance;
            const bool small = fragments[met.point].at.share < kSmallShare;
            const auto replace = [&](std::uint32_t cell) {
                if (site.near_cells[cell] && met.close == (site.close_cells[cell] && !small)) {
                    points_[met.point].light.soft += (met.close ? 1.0F / kCloseRays : 1) * near *
                                                     cosines_[met.point].of[cell] * (light - site.table.at(cell));
                }
            };
            replace(met.cell);
            if (small) {
                replace(table_partner(met.cell));
            }
        }
    }
}

void Shader::shade(std::span<const PlacedFragment> fragments, std::span<PointLight> light,
                   std::span<PointCounts> taken) {
    points_.clear();
    tasks_.clear();
    cosines_.clear();
    rays_.clear();
    owners_.clear();
    for (const PlacedFragment& fragment : fragments) {
        Point point;
        point.x = offset_origin(fragment.at.position, fragment.at.normal, 1);
        // A pixel has about as many for all of its fragments as for one.
        point.share_of_samples = std::pow(fragment.at.share, kShareOfSamples);
        point.first_task = static_cast<std::uint32_t>(tasks_.size());
        plan(fragment);
        point.end_task = static_cast<std::uint32_t>(tasks_.size());
        point.taken.on_surface = fragment.on_surface;
        point.taken.senders = point.end_task - point.first_task;
        points_.push_back(point);
        cosines_.emplace_back(fragment.at.shading_normal);
    }
    add_sky_rays(fragments);
    look_at_senders(fragments);
    trace();
    for (std::size_t p = 0; p < fragments.size(); ++p) {
        const PointLight light_here = light_of_models(fragments[p], points_[p], cosines_[p]);
        points_[p].light.all += light_here.all;
        points_[p].light.soft += light_here.soft;
    }
    add_near_light(fragments);
    for (std::size_t p = 0; p < fragments.size(); ++p) {
        light[p] = points_[p].light;
        light[p].sky = fragments[p].known.sky.value_or(light[p].sky);
        light[p].all += light[p].soft + light[p].sky;
        for (std::size_t k = points_[p].first_task; k < points_[p].end_task; ++k) {
            if (tasks_[k].visibility && !tasks_[k].soft) {
                light[p].glowing.push_back({tasks_[k].sender, tasks_[k].visible(), tasks_[k].bright});
            }
        }
        taken[p] = points_[p].taken;
        counts_.form_factors += taken[p].form_factors;
        counts_.on_surface += taken[p].on_surface;
    }
    counts_.points += fragments.size();
    counts_.senders += tasks_.size();
    counts_.visibility_rays += rays_.size();
}

}  // namespace gg
