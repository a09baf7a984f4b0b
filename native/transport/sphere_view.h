// Points of a sphere, or of a disk that faces its receiver in its place, even in the solid angle.
#pragma once

#include "core/wide.h"
#include "scene/scene.h"

namespace gg {

// Frame around d that turns continuously with d but for d = (0, 0, -1) [Frisvad 2012], with 1 + z taken from x and y
// where it would lose its digits. core's Frame flips where z changes sign, which would draw a line through penumbrae.
template <typename T>
[[nodiscard]] Vec3Of<T> continuous_to_world(const Vec3Of<T>& d, const Vec3Of<T>& local) {
    const T planar = d.x * d.x + d.y * d.y;
    const T one_plus_z = select(d.z < T(0), T(planar / (T(1) - d.z)), T(T(1) + d.z));
    const auto turned = one_plus_z > T(1e-12F);
    const T a = T(1) / select(turned, one_plus_z, T(1));
    const Vec3Of<T> tangent{T(1) - d.x * d.x * a, -d.x * d.y * a, -d.x};
    const Vec3Of<T> bitangent{-d.x * d.y * a, T(1) - d.y * d.y * a, -d.y};
    const Vec3Of<T> world = local.x * tangent + local.y * bitangent + local.z * d;
    return {select(turned, T(world.x), T(local.x)), select(turned, T(world.y), T(-local.y)),
            select(turned, T(world.z), T(-local.z))};
}

// Uniform in solid angle over the cone around unit `axis` whose half angle theta has 1 - cos theta = `depth`. disk: of
// the unit disk.
template <typename T>
[[nodiscard]] Vec3Of<T> sample_cone(const Vec3Of<T>& axis, const T& depth, Vec2 disk) {
    const T drop = T(disk.x * disk.x + disk.y * disk.y) * depth;  // 1 - cosine
    const T stretch = sqrt(depth * (T(2) - drop));
    return continuous_to_world<T>(axis, {disk.x * stretch, disk.y * stretch, T(1) - drop});
}

// As seen by a receiver. T: float, or Wide for several of them.
template <typename T>
struct SphereViewOf {
    Vec3Of<T> axis{T(0), T(0), T(1)};  // unit, towards the centre
    T distance = T(0);                 // to the centre, of a sphere at least the radius
    T sine_squared = T(0);             // of its angular radius
    T depth = T(0);                    // 1 - cosine of its angular radius

    void set(std::size_t lane, const SphereViewOf<float>& view) {
        axis.set(lane, view.axis);
        distance[lane] = view.distance;
        sine_squared[lane] = view.sine_squared;
        depth[lane] = view.depth;
    }

    // Along a direction with that cosine to the axis.
    [[nodiscard]] T distance_along(const Lamp& lamp, const T& cosine) const {
        if (lamp.faces_receivers) {
            return min(T(distance / max(cosine, T(1e-6F))), T(distance + lamp.radius));
        }
        const T sine = max(T(0), T(T(1) - cosine * cosine));  // squared
        // Near intersection: d cos t - sqrt(r^2 - d^2 sin^2 t), by its conjugate.
        const T reach = distance * cosine;
        const T half_chord = sqrt(max(T(0), T(T(lamp.radius * lamp.radius) - distance * distance * sine)));
        const T gap = (distance - lamp.radius) * (distance + lamp.radius);
        return select(gap > T(0), T(gap / max(T(reach + half_chord), T(1e-30F))), T(0));
    }
};

using SphereView = SphereViewOf<float>;

[[nodiscard]] inline SphereView view_sphere(const Lamp& lamp, Vec3 x) {
    SphereView view;
    const Vec3 to_center = lamp.position - x;
    const float distance = length(to_center);
    if (distance > 0) {
        view.axis = to_center / distance;
    }
    const float square = lamp.radius * lamp.radius;
    view.distance = lamp.faces_receivers ? distance : std::max(distance, lamp.radius);
    view.sine_squared = square / (view.distance * view.distance + (lamp.faces_receivers ? square : 0.0F));
    view.depth = view.sine_squared / (1 + std::sqrt(1 - view.sine_squared));
    return view;
}

}  // namespace gg
