#include "gather/sender_place.h"

#include <algorithm>
#include <cmath>

namespace gg {

namespace {

bool is_sun(const Scene& scene, const Node& sender) {
    return sender.kind == NodeKind::kLamp && scene.lamps[sender.source].shape == LampShape::kDistant;
}

// Of the sender's middle above the horizon, in its radii. Of the sun the middle is a direction.
float height(const Scene& scene, const Node& sender, Vec3 position, Vec3 normal) {
    constexpr float kLeast = 1e-6F;
    if (is_sun(scene, sender)) {
        const float cosine = scene.lamps[sender.source].cos_half_angle;
        return dot(sender.center, normal) / std::sqrt(std::max(1 - cosine * cosine, kLeast * kLeast));
    }
    return dot(sender.center - position, normal) / std::max(sender.radius, kLeast);
}

}  // namespace

bool is_below_horizon(const Scene& scene, const Node& sender, Vec3 position, Vec3 normal) {
    return height(scene, sender, position, normal) < -1;
}

bool crosses_horizon(const Scene& scene, const Node& sender, Vec3 position, Vec3 normal) {
    return std::abs(height(scene, sender, position, normal)) < 1;
}

bool is_close(const Scene& scene, const Node& sender, const Box& receivers) {
    constexpr float kClose = 2;  // times the size of both
    return !is_sun(scene, sender) &&
           length(sender.center - receivers.center()) < kClose * (sender.radius + 0.5F * receivers.diameter());
}

}  // namespace gg
