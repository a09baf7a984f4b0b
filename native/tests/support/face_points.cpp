#include "support/face_points.h"

#include <algorithm>

#include "core/random.h"

namespace gg::test {

FacePoints::FacePoints(const Hierarchy& hierarchy, const Node& node) {
    if (node.kind == NodeKind::kElement) {
        add(node.corner, node.normal, node.area);
        return;
    }
    hierarchy.for_each_triangle(node, [&](std::uint32_t instance, std::uint32_t triangle) {
        const auto corners = world_triangle(hierarchy.scene(), instance, triangle);
        const Vec3 area = world_area_vector(hierarchy.scene(), instance, triangle);
        const Sides sides = hierarchy.scene().sides_of(instance, triangle);
        if (sides != Sides::kBack) {
            add(corners, normalize_or_zero(area), length(area));
        }
        if (sides != Sides::kFront) {
            add(corners, -normalize_or_zero(area), length(area));
        }
    });
}

void FacePoints::add(const std::array<Vec3, 3>& corners, Vec3 normal, double area) {
    faces_.push_back({{corners[0], corners[1], corners[2]}, normal});
    prefix_.push_back(prefix_.back() + area);
}

EvenPoint FacePoints::sample(float u, float v, float w) const {
    const auto found = std::upper_bound(prefix_.begin() + 1, prefix_.end() - 1, u * prefix_.back());
    const Face& face = faces_[static_cast<std::size_t>(found - prefix_.begin() - 1)];
    const Vec3 weights = square_to_triangle(v, w);
    return {weights.x * face.corners[0] + weights.y * face.corners[1] + weights.z * face.corners[2], face.normal};
}

}  // namespace gg::test
