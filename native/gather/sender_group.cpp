#include "gather/sender_group.h"

#include <algorithm>

#include "core/random.h"
#include "gather/sender_light.h"
#include "radiosity/quarter.h"
#include "scene/light_units.h"
#include "transport/form_factor.h"

namespace gg {

void SenderGroup::begin(NodeId sender) {
    const Node& node = hierarchy_of(solution_)[sender];
    sender_ = sender;
    lamp_ = node.kind == NodeKind::kLamp ? &hierarchy_of(solution_).scene().lamps[node.source] : nullptr;
    sampler_.reset();
    blocks_.clear();
    count_ = looking_ = by_angle_ = 0;
}

void SenderGroup::add(Vec3 x, Vec3 n, bool looks) {
    const std::size_t lane = count_ % kLanes;
    if (lane == 0) {
        blocks_.emplace_back();
    }
    Block& block = blocks_.back();
    ++count_;
    block.x.set(lane, x);
    block.n.set(lane, n);
    if (!looks) {
        return;
    }
    ++looking_;
    if (!sampler_ && !is_cluster(hierarchy_of(solution_)[sender_])) {
        sampler_.emplace(solution_, sender_, x, n);
    }
    if (lamp_ == nullptr || (lamp_->shape != LampShape::kRectangle && lamp_->shape != LampShape::kSphere)) {
        return;
    }
    const LampSampler lamp(*lamp_, x, n);
    if (lamp_->shape == LampShape::kSphere) {
        block.sphere.set(lane, lamp.sphere());
    } else if (const SphericalRectangle* rectangle = lamp.rectangle()) {
        block.by_angle[lane] = 1;
        block.rectangle.set(lane, rectangle->view());
        block.warp.set(lane, lamp.warp() != nullptr ? *lamp.warp() : BilinearWarp());
        axis_x_ = rectangle->axis_x();
        axis_y_ = rectangle->axis_y();
        axis_z_ = rectangle->axis_z();
        ++by_angle_;
    }
}

std::uint32_t SenderGroup::most_points() const {
    if (is_cluster(hierarchy_of(solution_)[sender_])) {
        return kClusterPoints;
    }
    const bool single = lamp_ != nullptr && (lamp_->shape == LampShape::kPoint ||
                                             (lamp_->shape == LampShape::kDistant && lamp_->cos_half_angle >= 1));
    return single ? 1 : kMostPoints;
}

bool SenderGroup::infinite() const {
    return lamp_ != nullptr && lamp_->shape == LampShape::kDistant;
}

float SenderGroup::facing_weight(Vec3 x) const {
    const Node& node = hierarchy_of(solution_)[sender_];
    if (lamp_ != nullptr) {
        return luminance(lamp_irradiance_vector(*lamp_, x).irradiance);
    }
    const float strength =
        is_cluster(node) ? clusters_.of(sender_).power(0) : luminance(radiosity_of(solution_, sender_));
    return strength / (length_squared(node.center - x) + node.radius * node.radius);
}

std::span<const std::uint32_t> SenderGroup::in_blocks(std::uint32_t count, std::vector<std::uint32_t>& order) const {
    if (sampler_) {
        return sampler_->in_blocks(count, order);
    }
    order.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        order[i] = i;
    }
    return order;
}

bool SenderGroup::has_targets() const {
    return lamp_ == nullptr || lamp_->shape == LampShape::kRectangle || lamp_->shape == LampShape::kEllipse;
}

SenderGroup::Target SenderGroup::target(std::uint32_t index) const {
    const Node& node = hierarchy_of(solution_)[sender_];
    if (is_cluster(node)) {
        const FacePoint point = clusters_.of(sender_)[index];
        return {point.position, point.normal, luminance(point.power), 0, cluster_disk(node) / kPi};
    }
    const SenderPlace place = sampler_->place(index);
    if (lamp_ == nullptr) {
        const float soft = kSoftShare * node.area;
        return {place.target, node.normal, place.light, soft, soft};
    }
    return {place.target, lamp_->direction, luminance(lamp_->radiance) * flat_area(*lamp_), 0, 0};
}

SenderGroup::Seen SenderGroup::see(const Target& target, const Block& block) {
    const WideVec3 to = WideVec3(target.position) - block.x;
    const Wide square = dot(to, to);
    const Wide cosines = max(Wide(0), dot(block.n, to)) * max(Wide(0), Wide(-dot(WideVec3(target.normal), to)));
    const Wide squares = (square + target.soft) * (square + target.soft_again);
    return {to, select(cosines > 0, Wide(target.strength * cosines / max(squares, Wide(1e-30F))), 0)};
}

SenderGroup::Seen SenderGroup::see_rectangle(Vec2 place, const Block& block) const {
    const WideVec2 warped = block.warp.place(place.x, place.y);
    const WideVec2 at = block.rectangle.point(warped.x, warped.y);
    const WideVec3 to = at.x * WideVec3(axis_x_) + at.y * WideVec3(axis_y_) + block.rectangle.z * WideVec3(axis_z_);
    const Wide light = luminance(lamp_->radiance) * block.rectangle.solid_angle / block.warp.density(warped);
    return {to, light * max(Wide(0), Wide(dot(block.n, to) / sqrt(dot(to, to))))};
}

SenderGroup::Seen SenderGroup::see_sphere(Vec2 disk, const Block& block) const {
    const SphereViewOf<Wide>& view = block.sphere;
    const WideVec3 direction = sample_cone<Wide>(view.axis, view.depth, disk);
    const Wide light = 2 * kPi * luminance(lamp_->radiance) * view.depth *
                       spot_factor(*lamp_, Wide(-dot(WideVec3(lamp_->direction), direction)));
    return {view.distance_along(*lamp_, dot(direction, view.axis)) * direction,
            light * max(Wide(0), dot(block.n, direction))};
}

SenderGroup::Seen SenderGroup::see_point(const Block& block) const {
    const WideVec3 to = WideVec3(lamp_->position) - block.x;
    const Wide square = max(dot(to, to), Wide(1e-30F));
    const Wide distance = sqrt(square);
    const Wide light = luminance(lamp_->radiance) *
                       spot_factor(*lamp_, Wide(-dot(WideVec3(lamp_->direction), to) / distance)) / square;
    return {to, light * max(Wide(0), Wide(dot(block.n, to) / distance))};
}

SenderGroup::Seen SenderGroup::see_distant(const SenderPlace& place, const Block& block) {
    const WideVec3 direction(place.target);
    return {direction, place.light * max(Wide(0), dot(block.n, direction))};
}

// Of an element: sum over its parts of their form factors times their radiosities, which become even with distance.
SenderGroup::Lit SenderGroup::light_of_element(const Block& block) const {
    const Node& node = hierarchy_of(solution_)[sender_];
    const Rgb mean = radiosity_of(solution_, sender_);
    const WideVec3 to = WideVec3(node.center) - block.x;
    const WideMask front = dot(block.x - WideVec3(node.corner[0]), WideVec3(node.normal)) > 0;
    const Wide closeness = node.child_count > 0 ? Wide(0) : closeness_of(node, Wide(sqrt(dot(to, to))));
    Lit lit;
    lit.clipped = WideMask(false);
    if (none_of(front && closeness > 0)) {
        lit.light = select(front, points_to_triangle(block.x, block.n, node.corner, lit.clipped), 0) * WideVec3(mean);
    } else {
        const std::array<Rgb, 3> corners = corner_radiosity(solution_, sender_);
        for (int quarter = 0; quarter < kQuarters; ++quarter) {
            const auto own = quarter_of(corners, quarter);
            const Rgb uneven = (own[0] + own[1] + own[2]) / 3.0F - mean;
            WideMask clipped;
            const Wide factor = points_to_triangle(block.x, block.n, quarter_of(node.corner, quarter), clipped);
            lit.clipped = lit.clipped || clipped;
            lit.light = lit.light + select(front, factor, 0) * (WideVec3(mean) + closeness * WideVec3(uneven));
        }
    }
    lit.clipped = lit.clipped && front;
    return lit;
}

SenderGroup::Lit SenderGroup::light_of_rectangle(const Block& block) const {
    const std::array<Vec3, 4> corners = rectangle_corners(*lamp_);
    const WideMask front = dot(block.x - WideVec3(lamp_->position), WideVec3(lamp_->direction)) > 0;
    WideMask clipped;
    Lit lit;
    Wide factor = points_to_triangle(block.x, block.n, {corners[0], corners[1], corners[2]}, lit.clipped);
    factor += points_to_triangle(block.x, block.n, {corners[0], corners[2], corners[3]}, clipped);
    lit.clipped = front && (lit.clipped || clipped);
    lit.light = select(front, factor, 0) * WideVec3(kPi * lamp_->radiance);
    return lit;
}

void SenderGroup::light(std::vector<Rgb>& out) const {
    out.resize(count_);
    const bool element = hierarchy_of(solution_)[sender_].kind == NodeKind::kElement;
    const bool rectangle = lamp_ != nullptr && lamp_->shape == LampShape::kRectangle;
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
        const Block& block = blocks_[b];
        const Lit lit = element ? light_of_element(block) : rectangle ? light_of_rectangle(block) : Lit();
        for (std::size_t k = b * kLanes; k < std::min(count_, (b + 1) * kLanes); ++k) {
            const std::size_t lane = k % kLanes;
            out[k] = lit.clipped[lane]
                         ? unoccluded_irradiance(solution_, clusters_, sender_, block.x.lane(lane), block.n.lane(lane))
                         : lit.light.lane(lane);
        }
    }
}

void SenderGroup::see(std::uint32_t index, std::size_t receivers, GroupPoint& out) const {
    const std::size_t blocks = (receivers + kLanes - 1) / kLanes, size = blocks * kLanes;
    for (std::vector<float>* field : {&out.x, &out.y, &out.z, &out.weight}) {
        field->resize(size);
    }
    SenderPlace place;
    if (lamp_ != nullptr) {
        place = sampler_->place(index);
    }
    const Target common = has_targets() && by_angle_ < looking_ ? target(index) : Target();
    const Vec2 disk =
        lamp_ != nullptr && lamp_->shape == LampShape::kSphere ? square_to_disk(place.u, place.v) : Vec2(0);
    for (std::size_t b = 0; b < blocks; ++b) {
        const Block& block = blocks_[b];
        Seen seen;
        if (has_targets()) {
            if (by_angle_ < looking_) {
                seen = see(common, block);
            }
            if (by_angle_ > 0) {
                const Seen by_angle = see_rectangle({place.u, place.v}, block);
                const WideMask which = block.by_angle > 0;
                seen.direction = select(which, by_angle.direction, seen.direction);
                seen.weight = select(which, by_angle.weight, seen.weight);
            }
        } else {
            seen = lamp_->shape == LampShape::kSphere  ? see_sphere(disk, block)
                   : lamp_->shape == LampShape::kPoint ? see_point(block)
                                                       : see_distant(place, block);
        }
        const std::size_t first = b * kLanes;
        seen.direction.x.copy_to(&out.x[first], std::experimental::element_aligned);
        seen.direction.y.copy_to(&out.y[first], std::experimental::element_aligned);
        seen.direction.z.copy_to(&out.z[first], std::experimental::element_aligned);
        seen.weight.copy_to(&out.weight[first], std::experimental::element_aligned);
    }
}

}  // namespace gg
