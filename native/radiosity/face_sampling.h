// Points on the faces of a node, by area.
#pragma once

#include "radiosity/hierarchy.h"

namespace gg {

struct FacePoint {
    Vec3 position{0.0F};
    Vec3 normal{0.0F};  // unit, of the side that light reaches
    bool both_sides = false;  // light reaches the other side too
};

// u chooses the face, (v, w) the point on it; all in [0, 1). For elements u is not used. Surface nodes only.
[[nodiscard]] FacePoint sample_face(const Hierarchy& hierarchy, const Node& node, float u, float v, float w);

// The side of the point that sees `target`, or the only one that there is.
[[nodiscard]] inline Vec3 normal_towards(const FacePoint& point, Vec3 target) {
    return point.both_sides && dot(target - point.position, point.normal) < 0 ? -point.normal : point.normal;
}

}  // namespace gg
