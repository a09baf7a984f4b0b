// Points on the faces of a node, by area.
#pragma once

#include "radiosity/hierarchy.h"

namespace gg {

struct FacePoint {
    Vec3 position{0.0F};
    Vec3 normal{0.0F};          // unit, front
    float front = 1, back = 0;  // chance that a point is on this side; the sum is 1
};

// Light falls on all faces alike as far as rays know, and leaves from where it arrived: receivers have points by the
// area of every lit side, senders by area times exposure.
enum class Spread : std::uint8_t { kByArea, kByExposure };

// A point of a triangle, by area as far as the patch and those below it are exposed. u chooses the patch, `weights` are
// those of the corners.
[[nodiscard]] Vec3 sample_patch(const PatchForest& forest, std::uint32_t patch, std::array<Vec3, 3> corners, float u,
                                Vec3 weights);

// u chooses the face or patch, (v, w) the point on it; all in [0, 1). Surface nodes only.
[[nodiscard]] FacePoint sample_face(const Hierarchy& hierarchy, const Node& node, Spread spread, float u, float v,
                                    float w);

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
