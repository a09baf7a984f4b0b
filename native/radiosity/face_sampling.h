// Points on the faces of a node, by area.
#pragma once

#include "radiosity/hierarchy.h"

namespace gg {

struct FacePoint {
    Vec3 position{0.0F};
    Vec3 normal{0.0F};          // unit, front
    float front = 1, back = 0;  // chance that a point by area and exposure is on this side; the sum is 1
};

// u chooses the face, (v, w) the point on it; all in [0, 1). For elements u is not used. Surface nodes only.
[[nodiscard]] FacePoint sample_face(const Hierarchy& hierarchy, const Node& node, float u, float v, float w);

// The side of the point that sees `target`, and its chance.
struct FacingSide {
    Vec3 normal{0.0F};
    float chance = 0;
};

[[nodiscard]] inline FacingSide side_towards(const FacePoint& point, Vec3 target) {
    return dot(target - point.position, point.normal) < 0 ? FacingSide{-point.normal, point.back}
                                                          : FacingSide{point.normal, point.front};
}

}  // namespace gg
