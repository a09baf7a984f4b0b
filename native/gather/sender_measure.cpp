#include "gather/sender_measure.h"

#include <algorithm>

#include "gather/sender_light.h"
#include "gather/sender_place.h"
#include "transport/form_factor.h"

namespace gg {

namespace {

// Whether all of a box lies on the back of a plane.
bool is_behind(const Box& box, Vec3 on_plane, Vec3 normal) {
    return dot(box.center() - on_plane, normal) + 0.5F * dot(box.extent(), glm::abs(normal)) <= 0;
}

}  // namespace

void SenderMeter::look_from(std::span<const Receiver> receivers) {
    receivers_ = receivers;
    blocks_.assign((receivers.size() + kLanes - 1) / kLanes, {});
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        blocks_[i / kLanes].position.set(i % kLanes, receivers[i].position);
        blocks_[i / kLanes].normal.set(i % kLanes, receivers[i].shading_normal);
    }
}

SenderMeasure SenderMeter::measure(NodeId sender, std::size_t count) {
    sender_ = sender;
    sum_ = {};
    vectors_.clear();
    const Node& node = hierarchy_of(solution_)[sender];
    const bool rectangle = node.kind == NodeKind::kLamp &&
                           hierarchy_of(solution_).scene().lamps[node.source].shape == LampShape::kRectangle;
    if (node.kind == NodeKind::kElement || rectangle) {
        add_in_blocks(count);
    } else {
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

void SenderMeter::add(Vec3 vector, bool crosses_horizon) {
    vectors_.push_back(vector);
    sum_.largest = std::max(sum_.largest, length(vector));
    sum_.horizon = sum_.horizon || crosses_horizon;
}

// From afar an element is as good as a point.
WideVec3 SenderMeter::vectors_of_element(const Block& block) const {
    const Node& node = hierarchy_of(solution_)[sender_];
    const WideVec3 to = WideVec3(node.center) - block.position;
    const Wide square = dot(to, to);
    const WideMask front = dot(block.position - WideVec3(node.corner[0]), WideVec3(node.normal)) > 0;
    const WideMask far = square > kPointDistance * kPointDistance * node.radius * node.radius;
    const Wide facing = -dot(to, WideVec3(node.normal));
    WideVec3 vectors = Wide(node.area / kPi * facing / max(square * square, Wide(1e-30F))) * to;
    if (any_of(front && !far)) {
        vectors = select(far, vectors, vectors_to_triangle(block.position, node.corner));
    }
    return select(front, vectors, WideVec3());
}

WideVec3 SenderMeter::vectors_of_rectangle(const Lamp& lamp, const Block& block) {
    const std::array<Vec3, 4> corners = rectangle_corners(lamp);
    const WideMask front = dot(block.position - WideVec3(lamp.position), WideVec3(lamp.direction)) > 0;
    return select(front,
                  vectors_to_triangle(block.position, {corners[0], corners[1], corners[2]}) +
                      vectors_to_triangle(block.position, {corners[0], corners[2], corners[3]}),
                  WideVec3());
}

void SenderMeter::add_in_blocks(std::size_t count) {
    const Node& node = hierarchy_of(solution_)[sender_];
    const Lamp* lamp = node.kind == NodeKind::kLamp ? &hierarchy_of(solution_).scene().lamps[node.source] : nullptr;
    const Rgb radiosity = lamp != nullptr ? kPi * lamp->radiance : radiosity_of(solution_, sender_);
    for (std::size_t b = 0; b < blocks_.size() && vectors_.size() < count; ++b) {
        const Block& block = blocks_[b];
        const Wide height = dot(WideVec3(node.center) - block.position, block.normal);  // m, above the horizon
        const WideMask above = height >= -node.radius;
        if (none_of(above)) {
            continue;
        }
        const WideVec3 all = lamp != nullptr ? vectors_of_rectangle(*lamp, block) : vectors_of_element(block);
        const WideVec3 vectors = select(above, luminance(radiosity) * all, WideVec3());
        const Wide square = dot(vectors, vectors);
        const WideMask crosses = abs(height) < node.radius;
        for (std::size_t lane = 0; lane < std::min(kLanes, receivers_.size() - b * kLanes); ++lane) {
            if (square[lane] > 0) {
                add(vectors.lane(lane), crosses[lane]);
            }
        }
    }
    sum_.irradiance = radiosity;
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

float SenderMeter::bound(NodeId sender, const Box& box) const {
    const Node& node = hierarchy_of(solution_)[sender];
    if (node.kind == NodeKind::kLamp) {
        return kInfinity;
    }
    if (node.kind == NodeKind::kElement && is_behind(box, node.corner[0], node.normal)) {
        return 0;
    }
    const float distance = std::max(0.0F, length(node.center - box.center()) - node.radius - 0.5F * box.diameter());
    const float factor = node.area / std::max(kPi * distance * distance, 1e-20F);
    return std::min(factor, 1.0F) * luminance(radiosity_of(solution_, sender));
}

}  // namespace gg
