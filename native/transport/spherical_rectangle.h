// Points of a rectangle, even in the solid angle from which a receiver sees it [Urena, Fajardo and King 2013].
#pragma once

#include "core/wide.h"

namespace gg {

// The rectangle in axes of its own, as receivers see it, who look along -z. T: float, or Wide for several receivers.
template <typename T>
struct RectangleView {
    T x0 = T(0), x1 = T(0), y0 = T(0), y1 = T(0), z = T(-1);  // sides, relative to the receiver; z < 0
    T below = T(0), above = T(0);                             // z of the unit normals of the planes through these sides
    T offset = T(0);                                          // 2 pi less the angles at the left side
    T solid_angle = T(0);                                     // sr

    // The point of (u, v) in [0, 1]^2 in the rectangle's axes: uniform (u, v) are uniform in solid angle.
    [[nodiscard]] Vec2Of<T> point(const T& u, const T& v) const {
        const T angle = u * solid_angle + offset;
        const T sine = sin(angle);
        const T f = (cos(angle) * below - above) / select(abs(sine) > T(1e-30F), sine, T(1e-30F));
        const T c = clamp(T(copysign(T(1) / sqrt(f * f + below * below), f)), T(-1), T(1));
        const T x = clamp(T(-c * z / sqrt(max(T(1) - c * c, T(1e-30F)))), x0, x1);
        const T square = x * x + z * z;
        const T h0 = y0 / sqrt(square + y0 * y0), h1 = y1 / sqrt(square + y1 * y1);
        const T h = h0 + v * (h1 - h0);
        const T rest = T(1) - h * h;
        return {x, select(rest > T(1e-6F), clamp(T(h * sqrt(square / max(rest, T(1e-30F)))), y0, y1), y1)};
    }

    void set(std::size_t lane, const RectangleView<float>& view) {
        x0[lane] = view.x0;
        x1[lane] = view.x1;
        y0[lane] = view.y0;
        y1[lane] = view.y1;
        z[lane] = view.z;
        below[lane] = view.below;
        above[lane] = view.above;
        offset[lane] = view.offset;
        solid_angle[lane] = view.solid_angle;
    }
};

class SphericalRectangle {
  public:
    // A rectangle around `centre` that reaches from -half to +half along both of its sides, which are perpendicular, as
    // x sees it. x must not lie in its plane.
    SphericalRectangle(Vec3 centre, Vec3 half_x, Vec3 half_y, Vec3 x);

    [[nodiscard]] float solid_angle() const { return view_.solid_angle; }
    // The point of (u, v), relative to x.
    [[nodiscard]] Vec3 point(float u, float v) const {
        const Vec2 place = view_.point(u, v);
        return place.x * axis_x_ + place.y * axis_y_ + view_.z * axis_z_;
    }

    // point(0, 0) to point(1, 1).
    [[nodiscard]] Vec3 corner(bool right, bool above) const {
        return (right ? view_.x1 : view_.x0) * axis_x_ + (above ? view_.y1 : view_.y0) * axis_y_ + view_.z * axis_z_;
    }

    [[nodiscard]] const RectangleView<float>& view() const { return view_; }
    // Unit; z from the rectangle to x's side.
    [[nodiscard]] Vec3 axis_x() const { return axis_x_; }
    [[nodiscard]] Vec3 axis_y() const { return axis_y_; }
    [[nodiscard]] Vec3 axis_z() const { return axis_z_; }

  private:
    Vec3 axis_x_, axis_y_, axis_z_;
    RectangleView<float> view_;
};

}  // namespace gg
