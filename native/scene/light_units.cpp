#include "scene/light_units.h"

#include <algorithm>
#include <cmath>

#include "core/messages.h"

namespace gg {

namespace {

// What is wrong with the numbers, or null.
const char* find_fault(const LightDescription& light) {
    const Affine& map = light.to_world;
    if (!is_finite(light.power) || glm::any(glm::lessThan(light.power, Rgb(0)))) {
        return "Light has a negative or infinite power: left out";
    }
    if (!is_finite(map.translation) || !is_finite(map.linear[0]) || !is_finite(map.linear[1]) ||
        !is_finite(map.linear[2])) {
        return "Light has no usable matrix: left out";
    }
    if (light.type != LightType::kPoint && !(length(map.linear[2]) > 0)) {
        return "Light is scaled to nothing: left out";
    }
    const float sizes[] = {light.radius, light.size_x, light.size_y, light.spot_angle, light.spot_blend, light.angle};
    if (!std::all_of(std::begin(sizes), std::end(sizes), [](float size) { return std::isfinite(size) && size >= 0; })) {
        return "Light has a negative or infinite size: left out";
    }
    return nullptr;
}

void make_bulb(const LightDescription& light, Lamp& lamp) {
    const bool is_point = light.radius < kSmallestLampRadius;
    lamp.shape = is_point ? LampShape::kPoint : LampShape::kSphere;
    lamp.radius = is_point ? 0 : light.radius;
    lamp.faces_receivers = light.soft_falloff;
    lamp.radiance = light.power / (4 * kPi);
    if (!is_point) {
        lamp.radiance /= kPi * light.radius * light.radius;
    }
    if (light.type == LightType::kSpot) {
        lamp.is_spot = true;
        lamp.spot_cos = std::cos(0.5F * std::min(light.spot_angle, kPi));
        lamp.spot_smooth = (1 - lamp.spot_cos) * std::min(light.spot_blend, 1.0F);
    }
}

// False when it has no area.
bool make_panel(const LightDescription& light, Lamp& lamp) {
    lamp.shape = light.shape == AreaShape::kRectangle ? LampShape::kRectangle : LampShape::kEllipse;
    lamp.half_x = light.to_world.vector({0.5F * light.size_x, 0, 0});
    lamp.half_y = light.to_world.vector({0, 0.5F * light.size_y, 0});
    const Vec3 across = cross(lamp.half_x, lamp.half_y);
    const float area = (lamp.shape == LampShape::kRectangle ? 4 : kPi) * length(across);
    if (!(area > 1e-12F && std::isfinite(area))) {
        return false;
    }
    lamp.direction = normalize_or_zero(across) * (dot(across, lamp.direction) < 0 ? -1.0F : 1.0F);
    lamp.radiance = light.power / (4 * area);
    return true;
}

}  // namespace

std::optional<Lamp> make_lamp(const LightDescription& light, Messages& messages) {
    if (const char* fault = find_fault(light)) {
        messages.add(light.name, fault);
        return std::nullopt;
    }
    if (light.power == Rgb(0)) {
        return std::nullopt;
    }
    Lamp lamp;
    lamp.name = light.name;
    lamp.stable_id = light.stable_id;
    lamp.position = light.to_world.translation;
    if (light.type != LightType::kPoint) {
        lamp.direction = -glm::normalize(light.to_world.linear[2]);
    }
    switch (light.type) {
        case LightType::kPoint:
        case LightType::kSpot:
            make_bulb(light, lamp);
            break;
        case LightType::kSun:
            lamp.shape = LampShape::kDistant;
            lamp.irradiance = light.power;
            lamp.cos_half_angle = std::cos(0.5F * std::min(light.angle, kPi));
            break;
        case LightType::kArea:
            if (!make_panel(light, lamp)) {
                messages.add(light.name, "Area light has no area: left out");
                return std::nullopt;
            }
    }
    return lamp;
}

}  // namespace gg
