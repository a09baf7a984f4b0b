// Blender's lamps (watts, strengths, matrices) as radiances and irradiances, equal to Cycles.
//
// Measured with Cycles 3.4.1, a white diffuse plane under one lamp of power P, one sample's noise below 0.1 %:
//   point, spot   intensity P / (4 pi), radiance P / (4 pi^2 r^2); an object's scale changes nothing.
//                 Differs: Cycles 3.4 draws a disk that faces the receiver, not a sphere: at r = 1 m, d = 2 m it is 20
//                 % darker, at r = 0.1 m 0.25 %. The sphere is exact by the inverse square law, and later versions have
//                 it.
//   spot          falls off by cos(angle) as well as by the cone's smoothstep, see spot_factor.
//   area          radiance P / (4 A), where A is the placed area (pi/4 x y for ellipses): scaling keeps the flux.
//   sun           irradiance = strength; Cycles gives 2 / (1 + 1 / cos(half angle)) of that, 0.998 for 10 degrees.
#pragma once

#include <optional>

#include "core/wide.h"
#include "scene/description.h"
#include "scene/scene.h"

namespace gg {

class Messages;

// Below this radius [m] a point or spot is LampShape::kPoint: its sphere is too bright for floats to sample well.
inline constexpr float kSmallestLampRadius = 1e-4F;

// Nothing for a lamp that gives no light: silently when its power is zero, else with a message.
[[nodiscard]] std::optional<Lamp> make_lamp(const LightDescription& light, Messages& messages);

// Share of a spot's radiance or intensity, 0..1, that leaves at an angle with cosine `cos_angle` to its direction; 1
// for other lamps. cos_angle * smoothstep((cos_angle - spot_cos) / spot_smooth), 0 outside of the cone.
// T: float, or Wide for several angles.
template <typename T>
[[nodiscard]] T spot_factor(const Lamp& lamp, const T& cos_angle) {
    if (!lamp.is_spot) {
        return T(1);
    }
    const T inside = cos_angle - lamp.spot_cos;
    const T t = min(T(inside / max(lamp.spot_smooth, 1e-30F)), T(1));
    return select(inside > T(0) && cos_angle > T(0), T(cos_angle * t * t * (T(3) - T(2) * t)), T(0));
}

}  // namespace gg
