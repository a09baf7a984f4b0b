#include "radiosity/exchange.h"

#include <algorithm>
#include <cmath>

#include "radiosity/arrival.h"

namespace gg {

namespace {

bool all_behind(const Node& node, const Node& element) {
    if (node.kind == NodeKind::kElement) {
        return !in_front(node.corner[0], element) && !in_front(node.corner[1], element) &&
               !in_front(node.corner[2], element);
    }
    const Vec3 farthest(element.normal.x > 0 ? node.corner[1].x : node.corner[0].x,
                        element.normal.y > 0 ? node.corner[1].y : node.corner[0].y,
                        element.normal.z > 0 ? node.corner[1].z : node.corner[0].z);
    return !in_front(farthest, element);
}

bool behind_lamp(const Node& receiver, const Lamp& lamp) {
    if (lamp.shape != LampShape::kRectangle && lamp.shape != LampShape::kEllipse) {
        return false;
    }
    return dot(receiver.center - lamp.position, lamp.direction) < -receiver.radius;
}

}  // namespace

SpotEdge spot_edge(const Node& receiver, const Lamp& lamp) {
    if (!lamp.is_spot) {
        return SpotEdge::kInside;
    }
    const Vec3 to_receiver = receiver.center - lamp.position;
    const float distance = length(to_receiver);
    const float size = receiver.radius + lamp.radius;
    if (distance <= size) {
        return SpotEdge::kCrosses;
    }
    const float angle = std::acos(std::clamp(dot(to_receiver, lamp.direction) / distance, -1.0F, 1.0F));
    const float edge = std::acos(std::clamp(lamp.spot_cos, -1.0F, 1.0F));
    const float half_width = std::asin(size / distance);
    return angle - half_width > edge   ? SpotEdge::kOutside
           : angle + half_width < edge ? SpotEdge::kInside
                                       : SpotEdge::kCrosses;
}

bool never_exchange(const Hierarchy& hierarchy, const Node& receiver, const Node& sender) {
    if (!(receiver.weight > 0) || !(sender.weight > 0)) {
        return true;
    }
    if (receiver.kind == NodeKind::kElement && is_surface(sender) && all_behind(sender, receiver)) {
        return true;
    }
    if (sender.kind == NodeKind::kElement && all_behind(receiver, sender)) {
        return true;
    }
    if (sender.kind != NodeKind::kLamp) {
        return false;
    }
    const Lamp& lamp = hierarchy.scene().lamps[sender.source];
    return behind_lamp(receiver, lamp) || spot_edge(receiver, lamp) == SpotEdge::kOutside;
}

bool is_infinite(const Hierarchy& hierarchy, const Node& sender) {
    return sender.kind == NodeKind::kSky ||
           (sender.kind == NodeKind::kLamp && hierarchy.scene().lamps[sender.source].shape == LampShape::kDistant);
}

bool separated(const Node& receiver, const Node& sender) {
    return length(receiver.center - sender.center) > receiver.radius + sender.radius;
}

float form_factor_bound(const Hierarchy& hierarchy, const Node& receiver, const Node& sender) {
    if (sender.kind == NodeKind::kSky) {
        return sender.area / kPi;
    }
    if (sender.kind == NodeKind::kLamp) {
        const Lamp& lamp = hierarchy.scene().lamps[sender.source];
        if (lamp.shape == LampShape::kDistant) {
            return 1;
        }
        const float gap = length(receiver.center - sender.center) - receiver.radius;
        if (lamp.shape == LampShape::kPoint) {
            return 1 / std::max(gap * gap, 1e-12F);
        }
        return gap > sender.radius ? (sender.radius / gap) * (sender.radius / gap) : 1.0F;
    }
    const float gap = length(receiver.center - sender.center) - receiver.radius;
    if (gap <= sender.radius) {
        return 1;
    }
    const float shown = sender.kind == NodeKind::kElement ? sender.area : 0.25F * sender.area;
    const float sphere = (sender.radius / gap) * (sender.radius / gap);
    const float reach = gap - sender.radius;
    return std::min(sphere, shown / (kPi * reach * reach + shown));
}

}  // namespace gg
