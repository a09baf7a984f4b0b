#include "gather/shadow_samples.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "gather/sender_points.h"
#include "transport/emitter_sampling.h"
#include "transport/penumbra.h"

namespace gg {

namespace {

constexpr float kFewest = 4, kMost = kMostPoints;
constexpr float kStepsPerPixel = 8;    // for they are not all equally wide, and a pixel is looked at in one place
constexpr float kMostGrazing = 0.25F;  // cosine from which a penumbra is not taken to be wider

// Of the corners' distances from one another, across the direction.
float width_of(std::span<const Vec3> corners, Vec3 direction) {
    float largest = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        for (std::size_t j = i + 1; j < corners.size(); ++j) {
            const Vec3 edge = corners[j] - corners[i];
            largest = std::max(largest, length(edge - dot(edge, direction) * direction));
        }
    }
    return largest;
}

}  // namespace

float sender_width(const Scene& scene, const Node& sender, Vec3 direction) {
    if (sender.kind == NodeKind::kElement) {
        return width_of(sender.corner, direction);
    }
    if (sender.kind == NodeKind::kLamp) {
        const Lamp& lamp = scene.lamps[sender.source];
        switch (lamp.shape) {
            case LampShape::kPoint:
                return 0;
            case LampShape::kSphere:
                return 2 * lamp.radius;
            case LampShape::kDistant:
                return 2 * std::acos(std::clamp(lamp.cos_half_angle, -1.0F, 1.0F));
            case LampShape::kRectangle:
                return width_of(rectangle_corners(lamp), direction);
            case LampShape::kEllipse: {
                const std::array<Vec3, 4> ends{lamp.position - lamp.half_x, lamp.position + lamp.half_x,
                                               lamp.position - lamp.half_y, lamp.position + lamp.half_y};
                return width_of(ends, direction);
            }
        }
    }
    return 2 * sender.radius;
}

Shadow shadow_on(const ReceiverMeans& receivers, const Hierarchy& hierarchy, NodeId sender, Vec3 direction,
                 float irradiance, float occluder) {
    const Node& node = hierarchy[sender];
    const Scene& scene = hierarchy.scene();
    const bool infinite = node.kind == NodeKind::kLamp && scene.lamps[node.source].shape == LampShape::kDistant;
    return {sender_width(scene, node, direction),
            infinite ? kInfinity : length(node.center - receivers.position),
            occluder,
            dot(receivers.normal, direction),
            receivers.pixel,
            receivers.reflectance * irradiance};
}

float steps_in_pixels(const Shadow& shadow) {
    if (!(shadow.occluder > 0)) {
        return kInfinity;
    }
    const float width = std::isinf(shadow.distance) ? shadow.width * shadow.occluder
                                                    : penumbra_width(shadow.width, shadow.distance, shadow.occluder);
    return kStepsPerPixel * width / (std::max(shadow.cosine, kMostGrazing) * shadow.pixel);
}

float shadow_samples(const Shadow& shadow, float threshold) {
    return std::clamp(std::min(shadow.step / threshold, steps_in_pixels(shadow)), kFewest, kMost);
}

}  // namespace gg
