#include "transport/spherical_rectangle.h"

#include <algorithm>
#include <cmath>

namespace gg {

SphericalRectangle::SphericalRectangle(Vec3 centre, Vec3 half_x, Vec3 half_y, Vec3 x) {
    const Vec3 to = centre - x;
    axis_x_ = normalize_or_zero(half_x);
    axis_y_ = normalize_or_zero(half_y);
    axis_z_ = cross(axis_x_, axis_y_);
    if (dot(to, axis_z_) > 0) {
        axis_z_ = -axis_z_;
    }
    view_.x0 = dot(to, axis_x_) - length(half_x);
    view_.x1 = dot(to, axis_x_) + length(half_x);
    view_.y0 = dot(to, axis_y_) - length(half_y);
    view_.y1 = dot(to, axis_y_) + length(half_y);
    view_.z = dot(to, axis_z_);
    // z of the unit normals of the planes through x and the sides: below, right, above, left. Their angles follow.
    const auto z = static_cast<double>(view_.z);
    const auto height = [z](float side) {
        return static_cast<double>(side) / std::sqrt(static_cast<double>(side) * static_cast<double>(side) + z * z);
    };
    const double below = -height(view_.y0), right = height(view_.x1), above = height(view_.y1),
                 left = -height(view_.x0);
    const auto angle = [](double a, double b) { return std::acos(std::clamp(-a * b, -1.0, 1.0)); };
    const double offset = 2 * std::acos(-1.0) - angle(above, left) - angle(left, below);
    view_.below = static_cast<float>(below);
    view_.above = static_cast<float>(above);
    view_.offset = static_cast<float>(offset);
    view_.solid_angle = static_cast<float>(std::max(angle(below, right) + angle(right, above) - offset, 0.0));
}

}  // namespace gg
