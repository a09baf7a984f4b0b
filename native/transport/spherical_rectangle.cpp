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
    const auto along_x = static_cast<double>(dot(to, axis_x_)), along_y = static_cast<double>(dot(to, axis_y_));
    const auto wide = static_cast<double>(length(half_x)), high = static_cast<double>(length(half_y));
    x0_ = along_x - wide;
    x1_ = along_x + wide;
    y0_ = along_y - high;
    y1_ = along_y + high;
    z_ = static_cast<double>(dot(to, axis_z_));
    // z of the unit normals of the planes through x and the sides: below, right, above, left. Their angles follow.
    const auto height = [&](double side) { return side / std::sqrt(side * side + z_ * z_); };
    const double below = -height(y0_), right = height(x1_), above = height(y1_), left = -height(x0_);
    const auto angle = [](double a, double b) { return std::acos(std::clamp(-a * b, -1.0, 1.0)); };
    below_ = below;
    above_ = above;
    offset_ = 2 * std::acos(-1.0) - angle(above, left) - angle(left, below);
    solid_angle_ = std::max(angle(below, right) + angle(right, above) - offset_, 0.0);
}

Vec3 SphericalRectangle::point(float u, float v) const {
    const double angle = static_cast<double>(u) * solid_angle_ + offset_;
    const double sine = std::sin(angle);
    const double f = (std::cos(angle) * below_ - above_) / (std::abs(sine) > 1e-300 ? sine : 1e-300);
    const double c = std::clamp(std::copysign(1 / std::sqrt(f * f + below_ * below_), f), -1.0, 1.0);
    const double x = std::clamp(-c * z_ / std::sqrt(std::max(1 - c * c, 1e-300)), x0_, x1_);
    const double d = std::sqrt(x * x + z_ * z_);
    const double h0 = y0_ / std::sqrt(d * d + y0_ * y0_), h1 = y1_ / std::sqrt(d * d + y1_ * y1_);
    const double h = h0 + static_cast<double>(v) * (h1 - h0);
    const double rest = 1 - h * h;
    const double y = rest > 1e-12 ? std::clamp(h * d / std::sqrt(rest), y0_, y1_) : y1_;
    return static_cast<float>(x) * axis_x_ + static_cast<float>(y) * axis_y_ + static_cast<float>(z_) * axis_z_;
}

}  // namespace gg
