// What form factors of polygons are sums of. V: Vec3, Vec3d, or WideVec3 for several points of view.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "core/wide.h"
#include "transport/fast_angle.h"

namespace gg {

template <typename T>
inline constexpr T kPiOf = static_cast<T>(3.14159265358979323846);

// The contour sum subtracts numbers near 1 and has no digits left for small polygons far away: there, cubature over
// the area takes over. Value: (largest extent / smallest distance)^2 at which both errors are about equal; measured.
template <typename T>
inline constexpr T kSmallPolygon = std::is_same_v<T, float> ? T(1e-2) : T(1e-6);

// Share of the largest coordinate that rounding may have moved a point by.
template <typename T>
inline constexpr T kRounding = 16 * std::numeric_limits<T>::epsilon();

template <typename V>
using Scalar = typename V::value_type;

template <typename V>
[[nodiscard]] Scalar<V> largest_coordinate(V v) {
    return std::max(std::abs(v.x), std::max(std::abs(v.y), std::abs(v.z)));
}

// What the lanes hold.
template <typename T>
using Number = std::conditional_t<std::is_same_v<T, Wide>, float, T>;

// theta Gamma of the edge a-b as seen from the origin; zero when the origin lies on the edge's line.
template <typename V>
[[nodiscard]] V edge_term(const V& a, const V& b) {
    using T = Scalar<V>;
    const V normal = cross(a, b);
    const T sine_squared = dot(normal, normal);
    constexpr auto tolerance = 4 * std::numeric_limits<Number<T>>::epsilon();
    const auto apart = sine_squared > tolerance * tolerance * dot(a, a) * dot(b, b);
    const T sine = sqrt(select(apart, sine_squared, T(1)));
    return select(apart, T(fast_angle(sine, dot(a, b)) / sine), T(0)) * normal;
}

// Integral of |cos_y| m / (pi |m|^3) over a small triangle as seen from the origin, for its dot product with n to be
// the form factor: edge midpoints, exact for quadratic integrands. Signed by the winding.
template <typename V>
[[nodiscard]] V small_triangle(const V& a, const V& b, const V& c) {
    using T = Scalar<V>;
    V sum{};
    for (const V& doubled : {V(a + b), V(b + c), V(c + a)}) {
        const T squared = dot(doubled, doubled);
        sum = sum + T(T(1) / (squared * squared)) * doubled;
    }
    // Midpoints are half of `doubled`: (1/2) / (1/2)^4 = 8. The area is half of the cross product, the weights 1/3.
    constexpr auto factor = static_cast<Number<T>>(8 / (6 * kPiOf<double>));
    return T(dot(a, cross(V(b - a), V(c - a))) * factor) * sum;
}

}  // namespace gg
