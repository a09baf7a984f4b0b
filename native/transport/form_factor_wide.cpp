// Form factors of one triangle from several points.
#include "transport/form_factor.h"
#include "transport/triangle_terms.h"

namespace gg {

namespace {

// Of the lanes that are wanted.
inline WideVec3 vectors_in(const WideVec3& x, const std::array<Vec3, 3>& triangle, WideMask wanted) {
    const std::array<WideVec3, 3> sights{WideVec3(triangle[0]) - x, WideVec3(triangle[1]) - x,
                                         WideVec3(triangle[2]) - x};
    // As in view_polygon().
    const Vec3 b = triangle[1] - triangle[0], c = triangle[2] - triangle[0];
    const Vec3 doubled_area = cross(b, c);
    const Wide side = dot(WideVec3(doubled_area), sights[0]);
    Wide coordinate = max(abs(x.x), max(abs(x.y), abs(x.z)));
    for (const Vec3& corner : triangle) {
        coordinate = max(coordinate, Wide(largest_coordinate(corner)));
    }
    const WideMask seen = wanted && abs(side) > kRounding<float> * coordinate * length(doubled_area);
    const Wide nearest = min(dot(sights[0], sights[0]), min(dot(sights[1], sights[1]), dot(sights[2], sights[2])));
    const WideMask small = std::max(dot(b, b), dot(c, c)) < kSmallPolygon<float> * nearest;
    WideVec3 far, near;
    if (any_of(seen && small)) {
        far = small_triangle(sights[0], sights[1], sights[2]);
    }
    if (any_of(seen && !small)) {
        near = Wide(1 / (2 * kPi)) *
               (edge_term(sights[0], sights[1]) + edge_term(sights[1], sights[2]) + edge_term(sights[2], sights[0]));
    }
    return select(side > 0, Wide(1), Wide(-1)) * select(seen, select(small, far, near), WideVec3());
}

}  // namespace

WideVec3 vectors_to_triangle(const WideVec3& x, const std::array<Vec3, 3>& triangle) {
    return vectors_in(x, triangle, WideMask(true));
}

Wide points_to_triangle(const WideVec3& x, const WideVec3& n, const std::array<Vec3, 3>& triangle, WideMask& clipped) {
    Wide lowest = kInfinity, highest = -kInfinity;
    for (const Vec3& corner : triangle) {
        const Wide height = dot(n, WideVec3(corner) - x);
        lowest = min(lowest, height);
        highest = max(highest, height);
    }
    const WideMask above = lowest > 0;
    clipped = highest > 0 && !above;
    return any_of(above) ? clamp(dot(n, vectors_in(x, triangle, above)), Wide(0), Wide(1)) : Wide(0);
}

}  // namespace gg
