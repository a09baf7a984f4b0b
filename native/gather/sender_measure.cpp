#include "gather/sender_measure.h"

#include <algorithm>

#include "gather/sender_light.h"
#include "gather/sender_place.h"

namespace gg {

void SenderMeter::look_from(std::span<const Receiver> receivers) {
    receivers_ = receivers;
    blocks_.assign((receivers.size() + kLanes - 1) / kLanes, {});
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        blocks_[i / kLanes].position.set(i % kLanes, receivers[i].position);
        blocks_[i / kLanes].normal.set(i % kLanes, receivers[i].shading_normal);
    }
}

SenderMeasure SenderMeter::measure(NodeId sender, std::size_t count) {
    start(sender);
    if (hierarchy_of(solution_)[sender].kind != NodeKind::kElement || !add_from_afar(count)) {
        start(sender);
        add_one_by_one(count);
    }
    if (vectors_.empty()) {
        return {};
    }
    const auto share = 1 / static_cast<float>(vectors_.size());
    Vec3 mean(0.0F);
    for (const Vec3& vector : vectors_) {
        mean += share * vector;
    }
    const float size = length(mean), all = luminance(sum_.irradiance);
    sum_.irradiance *= all > 0 ? size / all : 0.0F;
    sum_.direction = size > 0 ? mean / size : Vec3(0, 0, 1);
    for (const Vec3& vector : vectors_) {
        sum_.spread = std::max(sum_.spread, 2 * length(vector - mean));
    }
    return sum_;
}

void SenderMeter::start(NodeId sender) {
    sender_ = sender;
    sum_ = {};
    vectors_.clear();
}

void SenderMeter::add(Vec3 vector, bool crosses_horizon) {
    vectors_.push_back(vector);
    sum_.largest = std::max(sum_.largest, length(vector));
    sum_.horizon = sum_.horizon || crosses_horizon;
}

// An element that is as good as a point for all receivers. Returns whether it is.
bool SenderMeter::add_from_afar(std::size_t count) {
    const Node& node = hierarchy_of(solution_)[sender_];
    const WideVec3 middle(node.center), normal(node.normal);
    const Rgb radiosity = radiosity_of(solution_, sender_);
    const float light = luminance(radiosity) * node.area / kPi;
    const float nearest = kPointDistance * kPointDistance * node.radius * node.radius;
    for (std::size_t b = 0; b < blocks_.size() && vectors_.size() < count; ++b) {
        const WideVec3 to = middle - blocks_[b].position;
        const Wide square = dot(to, to);
        const Wide height = dot(to, blocks_[b].normal);  // m, above the horizon
        const Wide facing = -dot(to, normal);
        const WideMask used = height >= -node.radius && facing > 0;
        if (any_of(used && square <= nearest)) {
            return false;
        }
        const Wide factor = select(used, Wide(light * facing / max(square * square, Wide(1e-30F))), 0);
        const WideMask crosses = abs(height) < node.radius;
        for (std::size_t lane = 0; lane < std::min(kLanes, receivers_.size() - b * kLanes); ++lane) {
            if (factor[lane] > 0) {
                add(factor[lane] * to.lane(lane), crosses[lane]);
            }
        }
    }
    sum_.irradiance = radiosity;
    return true;
}

void SenderMeter::add_one_by_one(std::size_t count) {
    const Scene& scene = hierarchy_of(solution_).scene();
    const Node& node = hierarchy_of(solution_)[sender_];
    for (const Receiver& receiver : receivers_) {
        if (vectors_.size() == count) {
            break;
        }
        if (is_below_horizon(scene, node, receiver.position, receiver.shading_normal)) {
            continue;
        }
        const IrradianceVector v = irradiance_vector(solution_, points_, sender_, receiver.position);
        const float size = luminance(v.irradiance);
        if (size > 0) {
            add(size * v.direction, crosses_horizon(scene, node, receiver.position, receiver.shading_normal));
            sum_.irradiance += v.irradiance;
        }
    }
}

}  // namespace gg
