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
    x0_ = dot(to, axis_x_) - length(half_x);
    x1_ = dot(to, axis_x_) + length(half_x);
    y0_ = dot(to, axis_y_) - length(half_y);
    y1_ = dot(to, axis_y_) + length(half_y);
    z_ = dot(to, axis_z_);
    // z of the unit normals of the planes through x and the sides: below, right, above, left. Their angles follow.
    const auto z = static_cast<double>(z_);
    const auto height = [z](float side) {
        return static_cast<double>(side) / std::sqrt(static_cast<double>(side) * static_cast<double>(side) + z * z);
    };
    const double below = -height(y0_), right = height(x1_), above = height(y1_), left = -height(x0_);
    const auto angle = [](double a, double b) { return std::acos(std::clamp(-a * b, -1.0, 1.0)); };
    const double offset = 2 * std::acos(-1.0) - angle(above, left) - angle(left, below);
    below_ = static_cast<float>(below);
    above_ = static_cast<float>(above);
    offset_ = static_cast<float>(offset);
    solid_angle_ = static_cast<float>(std::max(angle(below, right) + angle(right, above) - offset, 0.0));
}

Vec3 SphericalRectangle::point(float u, float v) const {
    const float angle = u * solid_angle_ + offset_;
    const float sine = std::sin(angle);
    const float f = (std::cos(angle) * below_ - above_) / (std::abs(sine) > 1e-30F ? sine : 1e-30F);
    const float c = std::clamp(std::copysign(1 / std::sqrt(f * f + below_ * below_), f), -1.0F, 1.0F);
    const float x = std::clamp(-c * z_ / std::sqrt(std::max(1 - c * c, 1e-30F)), x0_, x1_);
    const float square = x * x + z_ * z_;
    const float h0 = y0_ / std::sqrt(square + y0_ * y0_), h1 = y1_ / std::sqrt(square + y1_ * y1_);
    const float h = h0 + v * (h1 - h0);
    const float rest = 1 - h * h;
    const float y = rest > 1e-6F ? std::clamp(h * std::sqrt(square / rest), y0_, y1_) : y1_;
    return x * axis_x_ + y * axis_y_ + z_ * axis_z_;
}

}  // namespace gg
