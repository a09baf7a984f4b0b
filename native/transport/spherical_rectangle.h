// Points of a rectangle, even in the solid angle from which a receiver sees it [Urena, Fajardo and King 2013].
#pragma once

#include "core/vec.h"

namespace gg {

class SphericalRectangle {
  public:
    // A rectangle around `centre` that reaches from -half to +half along both of its sides, which are perpendicular, as
    // x sees it. x must not lie in its plane.
    SphericalRectangle(Vec3 centre, Vec3 half_x, Vec3 half_y, Vec3 x);

    [[nodiscard]] float solid_angle() const { return solid_angle_; }
    // The point of (u, v) in [0, 1]^2, relative to x: uniform (u, v) are uniform in solid angle.
    [[nodiscard]] Vec3 point(float u, float v) const;

  private:
    Vec3 axis_x_, axis_y_, axis_z_;  // unit; z from the rectangle to x's side
    float x0_, x1_, y0_, y1_, z_;    // the rectangle in these axes, seen from x; z < 0
    float below_, above_;            // z of the unit normals of the planes through x and these sides
    float offset_;                   // 2 pi less the angles at the left side
    float solid_angle_;
};

}  // namespace gg
