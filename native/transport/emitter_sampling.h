// Lamps as senders: their unoccluded irradiance in closed form, and points on them for visibility rays.
#pragma once

#include <array>
#include <optional>

#include "core/vec.h"
#include "scene/scene.h"
#include "transport/bilinear_warp.h"
#include "transport/sphere_view.h"
#include "transport/spherical_rectangle.h"

namespace gg {

// One point of a lamp as a receiver at x sees it.
struct LampSample {
    Vec3 point{0.0F};             // on the lamp; kDistant: x + direction
    Vec3 direction{0.0F};         // unit, from x to the sample
    float distance = 0;           // m; kDistant: infinity
    Rgb normal_irradiance{0.0F};  // W/m2, unoccluded, on a plane that faces the sample, if it stood for the whole lamp
};

// The sample of (u, v) in [0, 1)^2. The mean over uniform (u, v) of normal_irradiance * max(0, n.direction) is the
// unoccluded irradiance at x with normal n. Spheres are sampled by solid angle over the cap that x sees and distant
// disks by solid angle, so all of their samples weigh the same (spots aside), and so are rectangles but for those that
// are sheared or far; ellipses by area. None has a seam in x: a fixed (u, v) moves
// continuously with x, except for spheres and receivers exactly above their centre. Zero normal_irradiance: x is behind
// the lamp or outside the spot (direction and distance still hold), or on the sample itself (direction and distance are
// zero). A receiver inside a sphere counts as lying on its surface.
// far: half diagonals from which rectangles are sampled by area, which is faster; at 50 nothing shows.
[[nodiscard]] LampSample sample_lamp(const Lamp& lamp, Vec3 x, float u, float v, float far = 50);

// Of a rectangle, in order around it.
[[nodiscard]] std::array<Vec3, 4> rectangle_corners(const Lamp& lamp);

// Rectangles and ellipses: the point of (u, v), even in area, and the area of all [m2].
[[nodiscard]] Vec3 flat_point(const Lamp& lamp, float u, float v);
[[nodiscard]] float flat_area(const Lamp& lamp);

// The same for many samples at one receiver. Keeps a reference to the lamp.
class LampSampler {
  public:
    LampSampler(const Lamp& lamp, Vec3 x, float far = 50);
    // For a receiver with unit normal n: samples of rectangles are dense where the cosine is large, so that they bring
    // about the same.
    LampSampler(const Lamp& lamp, Vec3 x, Vec3 n);

    [[nodiscard]] LampSample sample(float u, float v) const;

    // How the receiver sees the lamp: null where a rectangle goes by area, or without a warp.
    [[nodiscard]] const SphericalRectangle* rectangle() const { return rectangle_ ? &*rectangle_ : nullptr; }
    [[nodiscard]] const BilinearWarp* warp() const { return warp_ ? &*warp_ : nullptr; }
    [[nodiscard]] const SphereView& sphere() const { return sphere_; }  // of spheres

  private:
    const Lamp& lamp_;
    Vec3 x_;
    std::optional<SphericalRectangle> rectangle_;
    std::optional<BilinearWarp> warp_;
    SphereView sphere_;
};

// Irradiance as a vector: `irradiance` [W/m2] falls on a plane at x that faces `direction` (unit, towards the lamp),
// and max(0, n.direction) of it on any normal above whose horizon the whole lamp lies.
struct IrradianceVector {
    Rgb irradiance{0.0F};
    Vec3 direction{0.0F, 0.0F, 1.0F};
};

// Of the unoccluded lamp. Exact for points, spheres (spot factor taken at the centre) and distant disks, to float
// rounding for rectangles; an ellipse counts as a 16-gon of its area.
[[nodiscard]] IrradianceVector lamp_irradiance_vector(const Lamp& lamp, Vec3 x);

// Irradiance [W/m2] of the unoccluded lamp at x on unit normal n, clipped against its horizon: also where part of the
// lamp lies behind the receiver. Distant disks count as their middle; the rest as for the vector.
[[nodiscard]] Rgb lamp_irradiance(const Lamp& lamp, Vec3 x, Vec3 n);

}  // namespace gg
