// Closed forms of unoccluded form factors, from a point. All dimensionless; a form factor times the sender's radiosity
// B [W/m2] is irradiance [W/m2]. V is Vec3 or Vec3d (scalar type T). Positions share one space and unit; normals are
// unit length and need not match the polygon. Polygons are planar; both of their sides count, in any winding: who needs
// one side tests it before. No input that is finite yields NaN; a degenerate polygon counts as zero.
//
// A polygon sees nothing of a point in its own plane: points closer to the plane than rounding can tell (2e-6 of the
// largest coordinate involved in float) get 0.
//
// Accuracy against exact arithmetic on the same inputs, float: see kFormFactorAccuracy; double: 1e-12 absolute.
#pragma once

#include <array>
#include <span>
#include <type_traits>

#include "core/wide.h"

namespace gg {

// Of the float versions of vector_form_factor, point_to_polygon and point_to_triangle, held by a test:
// |error| <= kFormFactorAccuracy * max(F, 1e-3), whatever the distance. Worst at 10 to 30 times the polygon's size,
// where the mean relative error is 3e-5; from 100 times on it is 1e-7, and 2e-5 at most unless grazing. Not within 1e-4
// of the polygon's plane, where the inputs' own rounding decides.
inline constexpr float kFormFactorAccuracy = 2e-4F;

// Phi = 1/(2 pi) sum_i theta_i Gamma_i over the edges, Gamma_i the unit normal of the triangle (x, v_i, v_i+1) and
// theta_i the angle that the edge subtends [Lambert 1760]. Points from x to the side on which the polygon lies. |Phi|
// in [0, 1] is the form factor of a plane at x that faces Phi; dot(n, Phi) is that of normal n as long as no part of
// the polygon lies below n's horizon. The polygon may be concave.
template <typename V>
[[nodiscard]] V vector_form_factor(V x, std::span<const std::type_identity_t<V>> polygon);

// Form factor from point x with unit normal n to a convex polygon, clipped against the horizon of n, in [0, 1].
template <typename V>
[[nodiscard]] typename V::value_type point_to_polygon(V x, V n, std::span<const std::type_identity_t<V>> polygon);

// The same for a triangle: the inner loop's version.
template <typename V>
[[nodiscard]] typename V::value_type point_to_triangle(V x, V n, V a, V b, V c);

// Of several points and one triangle: vector_form_factor().
[[nodiscard]] WideVec3 vectors_to_triangle(const WideVec3& x, const std::array<Vec3, 3>& triangle);

// The same, point_to_triangle(). clipped: lanes in which the horizon cuts the triangle; they get 0.
[[nodiscard]] Wide points_to_triangle(const WideVec3& x, const WideVec3& n, const std::array<Vec3, 3>& triangle,
                                      WideMask& clipped);

// Solid angle [sr], in [0, 2 pi], of a triangle given relative to the viewpoint [Van Oosterom and Strackee 1983].
template <typename V>
[[nodiscard]] typename V::value_type triangle_solid_angle(V a, V b, V c);

// Point to a sphere: cosine of the angle between the point's normal and the direction to the centre, and
// H = distance / radius > 0. Counts what is above the horizon; behind it is 0. H < 1 (inside) counts as H = 1.
template <typename T>
[[nodiscard]] T point_to_sphere(T cosine, T distance_over_radius);

// Bounded kernel A cos cos / (pi d^2 + A), exact for a facing coaxial disk of that area. >= 0; a negative cosine gives
// 0.
template <typename T>
[[nodiscard]] inline T disk_kernel(T cos_x, T cos_y, T distance_squared, T area) {
    if (!(cos_x > 0) || !(cos_y > 0) || !(area > 0)) {
        return 0;
    }
    return area * cos_x * cos_y / (static_cast<T>(3.14159265358979323846) * distance_squared + area);
}

// A small cone of directions, such as a piece of sky: Omega cos / pi. A negative cosine gives 0.
template <typename T>
[[nodiscard]] inline T cap_form_factor(T cos_x, T solid_angle) {
    return cos_x > 0 ? cos_x * solid_angle / static_cast<T>(3.14159265358979323846) : T(0);
}

}  // namespace gg
