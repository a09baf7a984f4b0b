// One mesh from its description: broken triangles left out, shading vertices and closed solids found.
#pragma once

#include <array>
#include <cstdint>

#include "scene/description.h"
#include "scene/scene.h"

namespace gg {

class Control;

// Why a triangle is left out, or kUsable.
enum class TriangleFault : std::uint8_t { kUsable, kBadIndex, kRepeatedVertex, kNotFinite, kNoArea };
inline constexpr std::size_t kTriangleFaults = 5;

// What a message says of each fault; kUsable: empty.
[[nodiscard]] const char* fault_text(TriangleFault fault);

struct ConvertedMesh {
    Mesh mesh;                                           // without triangles when none was usable
    std::array<std::uint32_t, kTriangleFaults> count{};  // triangles of the description by fault
    bool ignored_attributes = false;                     // slots, normals or uvs whose length does not fit the mesh
};

// A triangle needs coordinates below 1e9 m and a height over 3e-7 of its longest side: less is lost in rounding.
[[nodiscard]] ConvertedMesh convert_mesh(const MeshDescription& description, const Control& control);

}  // namespace gg
