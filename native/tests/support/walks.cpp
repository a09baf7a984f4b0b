#include "support/walks.h"

#include <cmath>
#include <optional>

#include "trace/surface_point.h"

namespace gg::test {

namespace {

std::optional<Fragment> seen_at(const GridPicture& picture, float x, float y) {
    const Ray ray = picture.view.camera.ray(x, y);
    const Hit hit = picture.prepared.tracer->closest_hit(ray, RayMask::kCamera);
    if (hit.missed()) {
        return {};
    }
    Fragment at = fragment_at(picture.prepared.scene, hit.instance, hit.triangle, {hit.u, hit.v});
    if (dot(at.normal, ray.direction) > 0) {
        at.back = true;
        at.normal = -at.normal;
        at.shading_normal = -at.shading_normal;
    }
    return at;
}

double light_of(const GridPicture& picture, const PlacedFragment& at, std::vector<oracle::SiteRay>* rays) {
    const oracle::ShadedScene scene{*picture.solution, picture.points, *picture.prepared.tracer};
    return static_cast<double>(luminance(Rgb(oracle::site_irradiance(scene, at, rays))));
}

}  // namespace

std::vector<Step> walk_steps(const GridPicture& picture, int rows, int points) {
    const auto width = static_cast<float>(picture.view.settings.crop.width),
               height = static_cast<float>(picture.view.settings.crop.height);
    std::vector<Step> steps;
    for (int row = 0; row < rows; ++row) {
        std::optional<Fragment> before;
        for (int i = 0; i < points; ++i) {
            const auto now = seen_at(picture, width * (static_cast<float>(i) + 0.5F) / static_cast<float>(points),
                                     height * (static_cast<float>(row) + 0.5F) / static_cast<float>(rows));
            if (before && now && before->hit.instance == now->hit.instance &&
                before->hit.triangle == now->hit.triangle && before->back == now->back) {
                steps.push_back({picture.place(*before), picture.place(*now)});
            }
            before = now;
        }
    }
    return steps;
}

bool has_same_sites(const Step& step) {
    bool same = step.from.count == step.to.count;
    for (std::uint32_t k = 0; same && k < step.from.count; ++k) {
        same = step.from.around[k].site == step.to.around[k].site;
    }
    return same;
}

Step narrow(const GridPicture& picture, Step step, Narrow to, float least) {
    const auto light = [&](const PlacedFragment& at) { return light_of(picture, at, nullptr); };
    double from_light = to == Narrow::kToJump ? light(step.from) : 0,
           to_light = to == Narrow::kToJump ? light(step.to) : 0;
    while (length(step.to.at.position - step.from.at.position) > least) {
        Fragment at = step.from.at;
        at.position = 0.5F * (step.from.at.position + step.to.at.position);
        at.hit.u = 0.5F * (step.from.at.hit.u + step.to.at.hit.u);
        at.hit.v = 0.5F * (step.from.at.hit.v + step.to.at.hit.v);
        at.shading_normal = normalize_or_zero(step.from.at.shading_normal + step.to.at.shading_normal);
        if (at.position == step.from.at.position || at.position == step.to.at.position) {
            break;
        }
        const PlacedFragment middle = picture.place(at);
        const double middle_light = to == Narrow::kToJump ? light(middle) : 0;
        const bool first = to == Narrow::kToJump
                               ? std::abs(middle_light - from_light) > std::abs(to_light - middle_light)
                               : !has_same_sites({step.from, middle});
        (first ? step.to : step.from) = middle;
        (first ? to_light : from_light) = middle_light;
    }
    return step;
}

WalkedLight walked_light(const GridPicture& picture, const PlacedFragment& at) {
    std::vector<oracle::SiteRay> rays;
    WalkedLight result;
    result.light = light_of(picture, at, &rays);
    for (const oracle::SiteRay& ray : rays) {
        const auto [found, is_new] = result.rays.insert({{ray.kind, ray.id, ray.index}, ray});
        found->second.light += is_new ? 0 : ray.light;
    }
    return result;
}

RayChange ray_change(const WalkedLight& from, const WalkedLight& to) {
    RayChange change;
    for (const auto& [key, now] : to.rays) {
        const auto found = from.rays.find(key);
        if (found == from.rays.end() || found->second.met == now.met) {
            continue;
        }
        const auto kind = static_cast<std::size_t>(now.kind);
        const double mean = 0.5 * (now.light + found->second.light);
        change.count[kind] += 1;
        change.light[kind] +=
            now.kind == oracle::RayKind::kNear ? now.light - found->second.light : (now.met == kNone ? mean : -mean);
    }
    return change;
}

}  // namespace gg::test
