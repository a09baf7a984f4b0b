#include "radiosity/gathered_light.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.h"
#include "radiosity/lighting.h"
#include "radiosity/opinions.h"

namespace gg {

namespace {

constexpr std::size_t kPlacesAtOnce = 32;
constexpr float kLeastOpen = 0.2F;  // of an element: what few points see is not trusted for more
// Trust::whole and Trust::part.
constexpr float kWhole = 1, kEmittedPart = 0.5F, kReflectedPart = 0.5F, kFacesPart = 2;

}  // namespace

GatheredLight::GatheredLight(const Hierarchy& hierarchy, const ElementTable& elements, const SourceGuide& guide,
                             const Lighting& lighting, std::span<const Rgb> emitted_by_links, const RayTracer& tracer,
                             int rays, float dark, const Control& control)
    : hierarchy_(&hierarchy), guide_(&guide) {
    find_groups(lighting, rays, control);
    list_elements(lighting, rays, dark);
    for (std::size_t i = 1; i < places_.size(); ++i) {
        places_[i].first_ray = places_[i - 1].first_ray + places_[i - 1].rays;
    }
    list_shares(control);
    emitted_.assign(places_.size(), Rgb(0.0F));
    emitted_squares_.assign(places_.size(), 0.0F);
    light_.assign(places_.size(), Rgb(0.0F));
    hits_.assign(places_.empty() ? 0 : places_.back().first_ray + places_.back().rays, kNone);
    parallel_blocks(places_.size(), kPlacesAtOnce, control,
                    [&](std::size_t begin, std::size_t end) { trace(begin, end, elements, lighting, tracer); });
    blend_emitted(emitted_by_links, control);
    opinions_.resize(places_.size());
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const Place& place = places_[i];
        const NodeId id = place.element;
        const Rgb by_links = id == kNone ? irradiance_[first_[place.instance] + place.group]
                                         : glm::max(lighting.irradiance(id) - emitted_by_links[id], Rgb(0.0F));
        opinions_[i] = {id == kNone ? place.cluster : id, place.area, by_links, Rgb(0.0F),
                        static_cast<float>(place.rays) / place.open};
    }
    find_spread();
}

void GatheredLight::blend_emitted(std::span<const Rgb> emitted_by_links, const Control& control) {
    const std::size_t count = places_.size() - first_element_;
    std::vector<Opinions> opinions(count);
    std::vector<float> variance(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Place& place = places_[first_element_ + i];
        const Rgb emitted = emitted_[first_element_ + i];
        opinions[i] = {place.element, place.area, emitted_by_links[place.element], place.open * emitted,
                       static_cast<float>(place.rays) / place.open};
        variance[i] = std::max(0.0F, emitted_squares_[first_element_ + i] - luminance(emitted) * luminance(emitted));
    }
    of_emitted_ = {kWhole, kEmittedPart, spread_of_rays(opinions, variance)};
    elements_.blend(opinions, of_emitted_, control);
    for (std::size_t i = 0; i < count; ++i) {
        emitted_[first_element_ + i] = opinions[i].by_rays / std::max(places_[first_element_ + i].open, kLeastOpen);
    }
}

void GatheredLight::find_spread() {
    std::vector<float> variance(places_.size());
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const Rgb light = reflected_to(i, variance[i]);
        (void)light;
        if (i < first_element_) {
            variance[i] += std::max(0.0F, emitted_squares_[i] - luminance(emitted_[i]) * luminance(emitted_[i]));
        }
    }
    const std::span<const Opinions> all = opinions_;
    const std::span<const float> variances = variance;
    of_faces_ = {kWhole, kFacesPart, spread_of_rays(all.first(first_element_), variances.first(first_element_))};
    of_elements_ = {kWhole, kReflectedPart,
                    spread_of_rays(all.subspan(first_element_), variances.subspan(first_element_))};
}

// What the rays of a place bring from surfaces; the variance of the luminance that one brings.
Rgb GatheredLight::reflected_to(std::size_t i, float& variance) const {
    const Place& place = places_[i];
    Rgb sum(0.0F);
    float squares = 0;
    for (std::size_t k = place.first_ray; k < place.first_ray + place.rays; ++k) {
        if (hits_[k] != kNone) {
            const Rgb light = radiosity_[hits_[k]];
            sum += light;
            squares += luminance(light) * luminance(light);
        }
    }
    const auto count = static_cast<float>(place.rays);
    const Rgb mean = sum / count;
    variance = std::max(0.0F, squares / count - luminance(mean) * luminance(mean)) * count / std::max(count - 1, 1.0F);
    return mean;
}

// One Jacobi step; returns the sum of all changes of reflected light, as a share of it.
double GatheredLight::iterate(const Control& control) {
    parallel_for(places_.size(), 1024, control, [&](std::size_t i) {
        float variance = 0;
        const Rgb reflected = reflected_to(i, variance);
        opinions_[i].by_rays = i < first_element_ ? emitted_[i] + reflected : places_[i].open * reflected;
    });
    std::vector<Opinions> opinions = opinions_;
    blend_faces(*hierarchy_, std::span(opinions).first(first_element_), of_faces_);
    elements_.blend(std::span(opinions).subspan(first_element_), of_elements_, control);
    double all = 0, change = 0;
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const Place& place = places_[i];
        light_[i] = i < first_element_ ? opinions[i].by_rays
                                       : emitted_[i] + opinions[i].by_rays / std::max(place.open, kLeastOpen);
        const Rgb next = place.reflectance * light_[i];
        change += place.area * std::abs(luminance(next) - luminance(radiosity_[i]));
        all += place.area * luminance(next);
        radiosity_[i] = next;
    }
    return change / std::max(all, 1e-300);
}

int GatheredLight::settle(int most, double converged, const Control& control) {
    for (int count = 1; count <= most; ++count) {
        if (iterate(control) <= converged) {
            return count;
        }
    }
    return most;
}

void GatheredLight::tell(Lighting& lighting, const Control& control) {
    for (std::size_t i = 0; i < first_element_; ++i) {
        irradiance_[first_[places_[i].instance] + places_[i].group] = light_[i];
    }
    parallel_for(leaves_.size(), 8, control, [&](std::size_t i) {
        Rgb arriving(0.0F), reflected(0.0F);
        DirectionalForm intensity;
        for (std::size_t k = i > 0 ? share_end_[i - 1] : 0; k < share_end_[i]; ++k) {
            const Share& share = shares_[k];
            const Rgb irradiance = irradiance_[share.group];
            arriving += share.area * irradiance;
            reflected += share.reflecting * irradiance;
            add_face(intensity, share.reflecting * irradiance / kPi, normalize_or_zero(share.facing));
        }
        lighting.set_faces_of(leaves_[i], arriving, reflected, intensity);
    });
    for (std::size_t i = first_element_; i < places_.size(); ++i) {
        lighting.set_irradiance(places_[i].element, light_[i]);
    }
    lighting.pull(control);
}

void GatheredLight::finish() {
    guide_ = nullptr;
    places_ = {};
    place_of_group_ = {};
    place_of_element_ = {};
    emitted_ = {};
    emitted_squares_ = {};
    light_ = {};
    opinions_ = {};
    elements_ = {};
    radiosity_ = {};
    hits_ = {};
    leaves_ = {};
    share_end_ = {};
    shares_ = {};
}

std::size_t GatheredLight::bytes() const {
    return (irradiance_.capacity() + emitted_.capacity() + light_.capacity() + radiosity_.capacity()) *
               sizeof(Rgb) +
           (first_.capacity() + place_of_group_.capacity() + place_of_element_.capacity() + hits_.capacity()) *
               sizeof(std::uint32_t) +
           places_.capacity() * sizeof(Place) + shares_.capacity() * sizeof(Share);
}

}  // namespace gg
