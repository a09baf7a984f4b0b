// The sphere of directions as two quadtrees of cells of equal solid angle: face 0 is the upper hemisphere (z > 0), face
// 1 the lower. The unit square of a face maps to the disk by Shirley and Chiu's concentric map and the disk to the
// hemisphere by Lambert's azimuthal equal-area map, r^2 = 1 - |z|, so each cell of level k has 2 pi / 4^k sr exactly,
// no cell crosses the horizon, and uniform (u, v) are uniform directions. Cells are about square around the poles and
// up to 2.5 times as tall as wide at the horizon.
#pragma once

#include <array>
#include <cstdint>

#include "core/vec.h"

namespace gg {

inline constexpr int kFinestSkyLevel = 15;

// Cell (i, j) of the 2^level x 2^level cells of a face.
struct SkyCell {
    std::uint8_t level = 0;  // 0..kFinestSkyLevel
    std::uint8_t face = 0;   // 0, 1
    std::uint16_t i = 0, j = 0;

    friend bool operator==(const SkyCell&, const SkyCell&) = default;
};

// The two hemispheres, which partition the sphere.
[[nodiscard]] constexpr std::array<SkyCell, 2> sky_roots() {
    return {SkyCell{0, 0, 0, 0}, SkyCell{0, 1, 0, 0}};
}

// The four cells of the next level that partition this one.
[[nodiscard]] std::array<SkyCell, 4> children(SkyCell cell);

// Unit direction of (u, v) in [0, 1]^2 of the cell, uniform in solid angle; (0.5, 0.5) is its middle.
[[nodiscard]] Vec3 cell_direction(SkyCell cell, float u, float v);

// The cell of the finest level that a unit direction is in.
[[nodiscard]] SkyCell finest_cell_at(Vec3 direction);

// Whether `part` is the cell or one of its descendants.
[[nodiscard]] bool contains(SkyCell cell, SkyCell part);

// [sr]
[[nodiscard]] float cell_solid_angle(SkyCell cell);

// Uniform direction of the whole sphere from the unit square.
[[nodiscard]] Vec3 square_to_sphere(float u, float v);

}  // namespace gg
