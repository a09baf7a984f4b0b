#include "radiosity/arrival.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "transport/emitter_sampling.h"
#include "transport/form_factor.h"

namespace gg {

namespace {

// The solid angle of a cone that gives a facing plane this form factor, over pi.
float cone_over_pi(float factor) {
    return 2 * (1 - std::sqrt(1 - std::min(factor, 1.0F)));
}

Arrival from_lamp(const Lamp& lamp, const Node& sender, Vec3 x) {
    const IrradianceVector vector = lamp_irradiance_vector(lamp, x);
    const float factor = luminance(vector.irradiance) / luminance(sender.emission);
    const bool has_area = lamp.shape != LampShape::kPoint && lamp.shape != LampShape::kDistant;
    return {factor, vector.direction, has_area ? cone_over_pi(factor) : factor};
}

Arrival from_cluster(const Node& sender, Vec3 x) {
    const Vec3 to_sender = sender.center - x;
    // Far-field: exact for a sphere of even brightness. The bound only matters for points that are almost inside.
    const float factor = 1.0F / (kPi * std::max(length_squared(to_sender), 0.25F * sender.radius * sender.radius));
    return {factor, normalize_or_zero(to_sender), factor};
}

Arrival from_element(const Node& sender, Vec3 x) {
    if (!in_front(x, sender)) {
        return {};
    }
    const Vec3 vector = vector_form_factor(x, sender.corner);
    const float factor = length(vector);
    if (!(factor > 0)) {
        return {};
    }
    const float solid_angle = triangle_solid_angle(sender.corner[0] - x, sender.corner[1] - x, sender.corner[2] - x);
    return {factor, vector / factor, solid_angle / kPi};
}

Arrival from_sky(const Node& sender) {
    constexpr int kGrid = 4;
    const SkyCell cell = sky_cell_of(sender);
    Vec3 sum(0.0F);
    for (int k = 0; k < kGrid * kGrid; ++k) {
        sum += cell_direction(cell, (static_cast<float>(k % kGrid) + 0.5F) / kGrid,
                              (static_cast<float>(k / kGrid) + 0.5F) / kGrid);
    }
    const float mean = length(sum) / (kGrid * kGrid);
    return {sender.area * mean / kPi, normalize_or_zero(sum), sender.area / kPi};
}

float sky_form_factor(const Node& sender, Vec3 normal) {
    constexpr int kGrid = 12;  // a quadrant of the sky on a level floor: 0.3 % off
    const SkyCell cell = sky_cell_of(sender);
    float sum = 0;
    for (int k = 0; k < kGrid * kGrid; ++k) {
        sum += std::max(0.0F, dot(normal, cell_direction(cell, (static_cast<float>(k % kGrid) + 0.5F) / kGrid,
                                                         (static_cast<float>(k / kGrid) + 0.5F) / kGrid)));
    }
    return cap_form_factor(sum / (kGrid * kGrid), sender.area);
}

}  // namespace

Arrival arrival(const Hierarchy& hierarchy, const Node& sender, Vec3 x) {
    switch (sender.kind) {
        case NodeKind::kElement:
            return from_element(sender, x);
        case NodeKind::kLamp:
            return from_lamp(hierarchy.scene().lamps[sender.source], sender, x);
        case NodeKind::kSky:
            return from_sky(sender);
        default:
            return from_cluster(sender, x);
    }
}

float form_factor_at(const Hierarchy& hierarchy, const Node& receiver, const Node& sender, Vec3 x) {
    if (sender.kind == NodeKind::kElement) {
        return in_front(x, sender)
                   ? point_to_triangle(x, receiver.normal, sender.corner[0], sender.corner[1], sender.corner[2])
                   : 0.0F;
    }
    if (sender.kind == NodeKind::kSky) {
        return sky_form_factor(sender, receiver.normal);
    }
    if (sender.kind == NodeKind::kLamp) {
        const Rgb irradiance = lamp_irradiance(hierarchy.scene().lamps[sender.source], x, receiver.normal);
        return luminance(irradiance) / luminance(sender.emission);
    }
    const Arrival light = arrival(hierarchy, sender, x);
    return light.factor * std::max(0.0F, dot(receiver.normal, light.direction));
}

}  // namespace gg
