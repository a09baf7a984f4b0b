// Finds closed solids in a mesh, so that no light is computed inside of them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"
#include "scene/scene.h"

namespace gg {

class Control;

// Per triangle, the sides that light can reach. A component (triangles connected by edges) is closed when each of its
// edges has exactly two triangles that run through it in opposite directions. Closed ones are lit from the side that
// looks out: kFront, or kBack when they are inside out. kBoth: open, without volume, or with another component in
// its box: things in a room, the glass around a filament.
// Triangles are of three distinct positions (after welding); they may have no area. welded: see weld_positions.
[[nodiscard]] std::vector<Sides> find_lit_sides(std::span<const Vec3> positions,
                                                std::span<const TriangleCorners> triangles,
                                                std::span<const std::uint32_t> welded, const Control& control);

}  // namespace gg
