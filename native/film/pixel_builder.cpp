#include "film/pixel_builder.h"

#include <algorithm>
#include <cmath>

#include "film/sample_color.h"

namespace gg {

namespace {

constexpr float kSameNormal = 0.97F;  // cosine of the largest angle within a fragment
constexpr float kSamePlane = 2;       // largest distance from a fragment's plane, in pixels

}  // namespace

Variety PixelBuilder::add(std::span<const Ray> rays, std::span<const Hit> hits) {
    PixelFragments pixel;
    pixel.samples = static_cast<std::uint32_t>(rays.size());
    const std::uint32_t kept = collect(rays, hits, pixel);
    pixel.emitted *= share_;
    pixel.alpha *= share_;
    pixel.kept = share_ * static_cast<float>(kept);
    for (const Part& part : parts_) {
        out_.fragments.push_back(fragment_of(part.places, part.fragment, share_));
    }
    pixel.end = static_cast<std::uint32_t>(out_.fragments.size());
    out_.pixels.push_back(pixel);
    variety_.several = parts_.size() > 1;
    for (std::size_t k = 0; expected_ != nullptr && k < parts_.size(); ++k) {
        const Fragment& at = out_.fragments[out_.fragments.size() - parts_.size() + k];
        variety_.reflecting.add(at.albedo / at.share * (*expected_)(at.hit, at.back) / kPi);
    }
    return variety_;
}

std::vector<FragmentPart> PixelBuilder::divide(std::span<const Ray> rays, std::span<const Hit> hits, int halvings) {
    PixelFragments pixel;
    collect(rays, hits, pixel);
    std::vector<FragmentPart> result;
    for (std::uint32_t k = 0; k < parts_.size(); ++k) {
        divide(parts_[k].places, halvings, {parts_[k].fragment, k}, share_, result);
    }
    return result;
}

// Sorts samples into parts. Returns how many are finite.
std::uint32_t PixelBuilder::collect(std::span<const Ray> rays, std::span<const Hit> hits, PixelFragments& pixel) {
    parts_.clear();
    variety_ = {};
    share_ = 1 / static_cast<float>(rays.size());
    std::uint32_t kept = 0;
    for (std::size_t sample = 0; sample < rays.size(); ++sample) {
        kept += add_sample(rays[sample], hits[sample], pixel) ? 1 : 0;
    }
    return kept;
}

// False for a sample that is not finite.
bool PixelBuilder::add_sample(const Ray& ray, const Hit& hit, PixelFragments& pixel) {
    if (hit.missed()) {
        variety_.shining.add(view_.settings.film_transparent ? Rgb(0.0F) : view_.scene.world);
        if (!view_.settings.film_transparent) {
            pixel.emitted += view_.scene.world;
            pixel.alpha += 1;
        }
        return true;
    }
    Place place{hit, surface_point(view_.scene, hit), Rgb(0.0F)};
    const bool back = dot(place.point.geometric_normal, ray.direction) > 0;
    if (back) {
        place.point.geometric_normal = -place.point.geometric_normal;
        place.point.shading_normal = -place.point.shading_normal;
    }
    const SampleColors colors = colors_at(view_, ray, hit, share_);
    if (!is_finite(colors.albedo) || !is_finite(colors.emission)) {
        return false;
    }
    if (irradiance_at_ != nullptr) {
        const Rgb reflected = colors.albedo * (*irradiance_at_)(hit, back) / kPi;
        if (!is_finite(reflected)) {
            return false;
        }
        pixel.emitted += reflected;
    }
    variety_.shining.add(colors.emission);
    variety_.albedo.add(colors.albedo);
    pixel.emitted += colors.emission;
    pixel.alpha += 1;
    if (irradiance_at_ != nullptr) {
        return true;
    }
    Part& part = part_of(place, back);
    place.albedo = colors.albedo;
    part.places.push_back(place);
    return true;
}

PixelBuilder::Part& PixelBuilder::part_of(const Place& place, bool back) {
    for (Part& part : parts_) {
        const Place& first = part.places.front();
        if (part.fragment.hit.instance == place.hit.instance && part.fragment.back == back &&
            dot(first.point.shading_normal, place.point.shading_normal) > kSameNormal &&
            std::abs(dot(place.point.position - first.point.position, first.point.geometric_normal)) < part.tolerance) {
            return part;
        }
    }
    parts_.emplace_back();
    parts_.back().fragment.hit = place.hit;
    parts_.back().fragment.back = back;
    parts_.back().tolerance = kSamePlane * view_.camera.pixel_size(place.hit.distance);
    return parts_.back();
}

// Orders places along the axis on which they spread most. Returns where the second half begins.
std::size_t PixelBuilder::halve(std::span<Place> places) {
    Box box;
    for (const Place& place : places) {
        box.extend(place.point.position);
    }
    const Vec3 extent = box.upper - box.lower;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : (extent.y >= extent.z ? 1 : 2);
    std::stable_sort(places.begin(), places.end(), [axis](const Place& a, const Place& b) {
        return a.point.position[axis] < b.point.position[axis];
    });
    return places.size() / 2;
}

void PixelBuilder::divide(std::span<Place> places, int halvings, const FragmentPart& whole, float share,
                          std::vector<FragmentPart>& out) {
    if (places.empty()) {
        return;
    }
    if (halvings == 0) {
        out.push_back({fragment_of(places, whole.at, share), whole.fragment});
        return;
    }
    const std::size_t half = halve(places);
    divide(places.first(half), halvings - 1, whole, share, out);
    divide(places.subspan(half), halvings - 1, whole, share, out);
}

// The place next to the middle stands for all. share: of a place.
Fragment PixelBuilder::fragment_of(std::span<const Place> places, Fragment fragment, float share) {
    Vec3 middle(0.0F);
    fragment.albedo = Rgb(0.0F);
    for (const Place& place : places) {
        middle += place.point.position / static_cast<float>(places.size());
        fragment.albedo += share * place.albedo;
    }
    const auto distance = [&](const Place& place) { return length_squared(place.point.position - middle); };
    const Place& best = *std::min_element(places.begin(), places.end(),
                                          [&](const Place& a, const Place& b) { return distance(a) < distance(b); });
    fragment.share = share * static_cast<float>(places.size());
    fragment.hit = best.hit;
    fragment.position = best.point.position;
    fragment.normal = best.point.geometric_normal;
    fragment.shading_normal = best.point.shading_normal;
    return fragment;
}

}  // namespace gg
