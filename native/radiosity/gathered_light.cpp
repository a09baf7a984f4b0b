#include "radiosity/gathered_light.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.h"
#include "radiosity/lighting.h"
#include "radiosity/opinions.h"
#include "radiosity/reference_white.h"

namespace gg {

namespace {

constexpr std::size_t kPlacesAtOnce = 32;
constexpr float kLeastOpen = 0.2F;          // of an element: what few points see is not trusted for more
constexpr Trust kReflected{1, 0.5F, 1.3F};  // fixed: where few rays miss what is bright, they agree, and are wrong

}  // namespace

GatheredLight::GatheredLight(const Hierarchy& hierarchy, const ElementTable& elements, const SourceGuide& guide,
                             const Lighting& lighting, std::span<const Rgb> emitted_by_links, const RayTracer& tracer,
                             int rays, const Control& control)
    : hierarchy_(&hierarchy), guide_(&guide) {
    const float white = std::max(reference_white(*hierarchy_, lighting).irradiance, 1e-30F);
    find_groups(lighting, white, rays, control);
    list_elements(lighting, white, rays);
    for (std::size_t i = 1; i < places_.size(); ++i) {
        places_[i].first_ray = places_[i - 1].first_ray + places_[i - 1].rays;
    }
    list_shares(control);
    emitted_.assign(places_.size(), Rgb(0.0F));
    light_.assign(places_.size(), Rgb(0.0F));
    hits_.assign(places_.empty() ? 0 : places_.back().first_ray + places_.back().rays, kNone);
    parallel_blocks(places_.size(), kPlacesAtOnce, control,
                    [&](std::size_t begin, std::size_t end) { trace(begin, end, elements, lighting, tracer); });
    for (std::size_t i = first_element_; i < places_.size(); ++i) {
        const Place& place = places_[i];
        const Rgb by_links = glm::max(lighting.irradiance(place.element) - emitted_by_links[place.element], Rgb(0.0F));
        opinions_.push_back({by_links, Rgb(0.0F), static_cast<float>(place.rays) / place.open});
    }
}

// What the rays of a place bring from surfaces.
Rgb GatheredLight::reflected_to(std::size_t i) const {
    const Place& place = places_[i];
    Rgb sum(0.0F);
    for (std::size_t k = place.first_ray; k < place.first_ray + place.rays; ++k) {
        if (hits_[k] != kNone) {
            sum += radiosity_[hits_[k]];
        }
    }
    return sum / static_cast<float>(place.rays);
}

// One Jacobi step; returns the sum of all changes of reflected light, as a share of it.
double GatheredLight::iterate(const Control& control) {
    parallel_for(places_.size(), 1024, control, [&](std::size_t i) { light_[i] = reflected_to(i); });
    for (std::size_t i = 0; i < opinions_.size(); ++i) {
        opinions_[i].by_rays = places_[first_element_ + i].open * light_[first_element_ + i];
    }
    of_elements_.blend(opinions_, kReflected, control);
    for (std::size_t i = 0; i < opinions_.size(); ++i) {
        light_[first_element_ + i] = opinions_[i].by_rays / std::max(places_[first_element_ + i].open, kLeastOpen);
    }
    double all = 0, change = 0;
    for (std::size_t i = 0; i < places_.size(); ++i) {
        light_[i] += emitted_[i];
        const Rgb next = places_[i].reflectance * light_[i];
        change += places_[i].area * std::abs(luminance(next) - luminance(radiosity_[i]));
        all += places_[i].area * luminance(next);
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
    light_ = {};
    opinions_ = {};
    of_elements_ = {};
    radiosity_ = {};
    hits_ = {};
    leaves_ = {};
    share_end_ = {};
    shares_ = {};
}

std::size_t GatheredLight::bytes() const {
    return (irradiance_.capacity() + emitted_.capacity() + light_.capacity() + radiosity_.capacity()) * sizeof(Rgb) +
           (first_.capacity() + place_of_group_.capacity() + place_of_element_.capacity() + hits_.capacity()) *
               sizeof(std::uint32_t) +
           places_.capacity() * sizeof(Place) + shares_.capacity() * sizeof(Share);
}

}  // namespace gg
