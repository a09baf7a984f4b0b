#include "radiosity/gathered_light.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.h"
#include "radiosity/correction.h"
#include "radiosity/exchange.h"
#include "radiosity/lighting.h"

namespace gg {

namespace {

constexpr std::size_t kPlacesAtOnce = 32;

}  // namespace

GatheredLight::GatheredLight(const Hierarchy& hierarchy, const ElementTable& elements, const Lighting& lighting,
                             const RayTracer& tracer, int rays, const Control& control)
    : hierarchy_(&hierarchy) {
    find_groups(lighting, rays, control);
    list_elements(rays);
    find_emitters();
    for (std::size_t i = 1; i < places_.size(); ++i) {
        places_[i].first_ray = places_[i - 1].first_ray + places_[i - 1].rays;
    }
    list_shares(control);
    Lighting close_by = lighting;
    close_by.clear(control);
    for (const NodeId sender : hierarchy.infinite_and_lamps()) {
        if (is_infinite(hierarchy, hierarchy[sender])) {
            close_by.darken(sender);
        }
    }
    close_by.iterate(control);
    for (const NodeId element : elements_) {
        direct_.push_back(close_by.irradiance(element));
    }
    constant_.assign(places_.size(), Rgb(0.0F));
    glow_.assign(places_.size(), Rgb(0.0F));
    hits_.assign(places_.empty() ? 0 : places_.back().first_ray + places_.back().rays, kNone);
    estimates_.resize(places_.size() - first_element_);
    parallel_blocks(places_.size(), kPlacesAtOnce, control,
                    [&](std::size_t begin, std::size_t end) { trace(begin, end, elements, lighting, tracer); });
}

Rgb GatheredLight::sent_by(NodeId element, bool to_element, const Lighting& lighting) const {
    const bool all = !to_element && emitters_.empty();
    return lighting.radiosity(element) - (all ? Rgb(0.0F) : (*hierarchy_)[element].emission);
}

// What the rays of a place bring from surfaces.
GatheredLight::Estimate GatheredLight::from_surfaces(std::size_t i, const Lighting& lighting) const {
    const Place& place = places_[i];
    const auto count = static_cast<float>(place.rays);
    Rgb sum(0.0F);
    float squares = 0;
    for (std::size_t k = place.first_ray; k < place.first_ray + place.rays; ++k) {
        const std::uint32_t hit = hits_[k];
        if (hit != kNone) {
            const Rgb radiosity = hit & kElementBit ? sent_by(hit & ~kElementBit, place.element != kNone, lighting)
                                                    : reflectance_[hit] * irradiance_[hit];
            sum += radiosity;
            squares += luminance(radiosity) * luminance(radiosity);
        }
    }
    const Rgb mean = sum / count;
    const float spread = std::max(0.0F, squares / count - luminance(mean) * luminance(mean));
    return {glow_[i] + mean, spread * count / std::max(count - 1, 1.0F), place.rays};
}

void GatheredLight::gather(const Lighting& lighting, const Control& control) {
    std::vector<Rgb> next = irradiance_;
    parallel_for(places_.size(), 1024, control, [&](std::size_t i) {
        const Estimate light = from_surfaces(i, lighting);
        if (i < first_element_) {
            next[first_[places_[i].instance] + places_[i].group] = constant_[i] + light.irradiance;
        } else {
            estimates_[i - first_element_] = light;
            estimates_[i - first_element_].irradiance += constant_[i];
        }
    });
    irradiance_ = std::move(next);
}

void GatheredLight::tell(Lighting& lighting, const Control& control) const {
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
}

void GatheredLight::correct(Lighting& lighting, const Control& control) const {
    correct_elements(*hierarchy_, elements_, direct_, estimates_, lighting, control);
}

void GatheredLight::finish() {
    places_ = {};
    elements_ = {};
    estimates_ = {};
    direct_ = {};
    constant_ = {};
    glow_ = {};
    hits_ = {};
    reflectance_ = {};
    leaves_ = {};
    share_end_ = {};
    shares_ = {};
}

std::size_t GatheredLight::bytes() const {
    return (irradiance_.capacity() + reflectance_.capacity() + constant_.capacity()) * sizeof(Rgb) +
           (first_.capacity() + hits_.capacity()) * sizeof(std::uint32_t) + places_.capacity() * sizeof(Place) +
           shares_.capacity() * sizeof(Share);
}

}  // namespace gg
