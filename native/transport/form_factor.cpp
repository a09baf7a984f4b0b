#include "transport/form_factor.h"

#include <array>
#include <cmath>
#include <limits>

#include "transport/triangle_terms.h"

namespace gg {
namespace {

// What is known of a polygon before its integral: where its plane lies and whether it is small.
template <typename T>
struct View {
    T side = 0;  // signed distance of its plane times twice its area; 0: degenerate, or x lies in the plane
    bool small = false;
};

template <typename V>
View<Scalar<V>> view_polygon(V x, std::span<const V> polygon) {
    using T = Scalar<V>;
    if (polygon.size() < 3) {
        return {};
    }
    V doubled_area(0);
    T extent = 0;
    T nearest = std::numeric_limits<T>::infinity();
    T coordinate = largest_coordinate(x);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const V edge = polygon[i] - polygon[0];
        const V sight = polygon[i] - x;
        if (i + 1 < polygon.size()) {
            doubled_area += glm::cross(edge, V(polygon[i + 1] - polygon[0]));
        }
        extent = std::max(extent, glm::dot(edge, edge));
        nearest = std::min(nearest, glm::dot(sight, sight));
        coordinate = std::max(coordinate, largest_coordinate(polygon[i]));
    }
    const T side = glm::dot(doubled_area, V(polygon[0] - x));
    if (!(std::abs(side) > kRounding<T> * coordinate * glm::length(doubled_area))) {
        return {};
    }
    return {side, extent < kSmallPolygon<T> * nearest};
}

// The triangle above the horizon of n: its corners relative to x, in order.
template <typename V>
struct ClippedTriangle {
    std::array<V, 4> corners;
    int count = 0;
};

template <typename V>
ClippedTriangle<V> clip(const std::array<V, 3>& triangle, V n) {
    using T = Scalar<V>;
    const std::array<T, 3> height{glm::dot(n, triangle[0]), glm::dot(n, triangle[1]), glm::dot(n, triangle[2])};
    ClippedTriangle<V> result;
    for (int i = 0; i < 3; ++i) {
        const int next = i == 2 ? 0 : i + 1;
        if (height[i] > 0) {
            result.corners[result.count++] = triangle[i];
        }
        if ((height[i] > 0) != (height[next] > 0)) {
            const T t = height[i] / (height[i] - height[next]);
            result.corners[result.count++] = triangle[i] + t * (triangle[next] - triangle[i]);
        }
    }
    return result;
}

// Calls visit(a, b) for the edges, relative to x, of the part of a convex polygon above the horizon of n; the edge
// along the horizon comes last. Needs no memory for the clipped polygon, however many corners there are.
template <typename V, typename Visit>
void for_each_clipped_edge(V x, V n, std::span<const V> polygon, const Visit& visit) {
    using T = Scalar<V>;
    V leaving(0);
    V entering(0);
    bool crossed = false;
    V a = polygon.back() - x;
    T height_a = glm::dot(n, a);
    for (const V& vertex : polygon) {
        const V b = vertex - x;
        const T height_b = glm::dot(n, b);
        if (height_a > 0 && height_b > 0) {
            visit(a, b);
        } else if (height_a > 0 || height_b > 0) {
            const V crossing = a + (height_a / (height_a - height_b)) * (b - a);
            crossed = true;
            if (height_a > 0) {
                leaving = crossing;
                visit(a, crossing);
            } else {
                entering = crossing;
                visit(crossing, b);
            }
        }
        a = b;
        height_a = height_b;
    }
    if (crossed) {
        visit(leaving, entering);
    }
}

template <typename T>
T unit_clamp(T value) {
    return std::clamp(value, T(0), T(1));
}

}  // namespace

template <typename V>
V vector_form_factor(V x, std::span<const std::type_identity_t<V>> polygon) {
    using T = Scalar<V>;
    const View<T> view = view_polygon(x, polygon);
    if (view.side == 0) {
        return V(0);
    }
    V sum(0);
    if (view.small) {
        for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
            sum += small_triangle<V>(polygon[0] - x, polygon[i] - x, polygon[i + 1] - x);
        }
        return view.side > 0 ? sum : -sum;
    }
    V a = polygon.back() - x;
    for (const V& vertex : polygon) {
        const V b = vertex - x;
        sum += edge_term(a, b);
        a = b;
    }
    // Counter-clockwise as seen from x, the edge normals point to the inside of the cone of sight, where the polygon
    // is; that winding's area vector points back to x: side < 0.
    return sum * ((view.side > 0 ? T(1) : T(-1)) / (2 * kPiOf<T>));
}

template <typename V>
typename V::value_type point_to_polygon(V x, V n, std::span<const std::type_identity_t<V>> polygon) {
    using T = Scalar<V>;
    const View<T> view = view_polygon(x, polygon);
    if (view.side == 0) {
        return 0;
    }
    T sum = 0;
    if (view.small) {
        V apex(0);
        bool first = true;
        for_each_clipped_edge<V>(x, n, polygon, [&](V a, V b) {
            if (first) {
                apex = a;
                first = false;
            }
            sum += glm::dot(n, small_triangle(apex, a, b));
        });
        return unit_clamp(std::abs(sum));
    }
    for_each_clipped_edge<V>(x, n, polygon, [&](V a, V b) { sum += glm::dot(n, edge_term(a, b)); });
    return unit_clamp(std::abs(sum) / (2 * kPiOf<T>));
}

template <typename V>
typename V::value_type point_to_triangle(V x, V n, V a, V b, V c) {
    using T = Scalar<V>;
    const std::array<V, 3> sights{a - x, b - x, c - x};
    const ClippedTriangle<V> clipped = clip(sights, n);
    if (clipped.count == 0) {
        return 0;
    }
    const View<T> view = view_polygon<V>(x, std::array<V, 3>{a, b, c});
    if (view.side == 0) {
        return 0;
    }
    T sum = 0;
    if (view.small) {
        for (int i = 1; i + 1 < clipped.count; ++i) {
            sum += glm::dot(n, small_triangle(clipped.corners[0], clipped.corners[i], clipped.corners[i + 1]));
        }
        return unit_clamp(std::abs(sum));
    }
    for (int i = 0; i < clipped.count; ++i) {
        sum += glm::dot(n, edge_term(clipped.corners[i], clipped.corners[i + 1 == clipped.count ? 0 : i + 1]));
    }
    return unit_clamp(std::abs(sum) / (2 * kPiOf<T>));
}

template <typename V>
typename V::value_type triangle_solid_angle(V a, V b, V c) {
    using T = Scalar<V>;
    const T length_a = glm::length(a);
    const T length_b = glm::length(b);
    const T length_c = glm::length(c);
    // a.(b x c), from edges: keeps its digits when the triangle is small.
    const T volume = std::abs(glm::dot(a, glm::cross(b - a, c - a)));
    const T denominator = length_a * length_b * length_c + glm::dot(a, b) * length_c + glm::dot(a, c) * length_b +
                          glm::dot(b, c) * length_a;
    return volume > 0 ? 2 * std::atan2(volume, denominator) : T(0);
}

// [Howell, element to sphere, tilted]: with k^2 = 1 - H^2 c^2 and s^2 = H^2 - 1, both inverse cosines are angles whose
// sine and cosine are known, which keeps the digits near grazing. In double, since the terms of a small sphere cancel.
template <typename T>
T point_to_sphere(T cosine, T distance_over_radius) {
    const double h = std::max(static_cast<double>(distance_over_radius), 1.0);
    const double c = std::clamp(static_cast<double>(cosine), -1.0, 1.0);
    if (c * h >= 1) {
        return static_cast<T>(c / (h * h));
    }
    if (c * h <= -1) {
        return 0;
    }
    const double k = std::sqrt(1 - h * h * c * c);
    const double s = std::sqrt(h * h - 1);
    const double above = (c * std::atan2(k, -c * s) - k * s) / (h * h) + std::atan2(k, s);
    return static_cast<T>(unit_clamp(above / kPiOf<double>));
}

template Vec3 vector_form_factor(Vec3, std::span<const Vec3>);
template Vec3d vector_form_factor(Vec3d, std::span<const Vec3d>);
template float point_to_polygon(Vec3, Vec3, std::span<const Vec3>);
template double point_to_polygon(Vec3d, Vec3d, std::span<const Vec3d>);
template float point_to_triangle(Vec3, Vec3, Vec3, Vec3, Vec3);
template double point_to_triangle(Vec3d, Vec3d, Vec3d, Vec3d, Vec3d);
template float triangle_solid_angle(Vec3, Vec3, Vec3);
template double triangle_solid_angle(Vec3d, Vec3d, Vec3d);
template float point_to_sphere(float, float);
template double point_to_sphere(double, double);

}  // namespace gg
