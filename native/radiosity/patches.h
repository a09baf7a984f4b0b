// Which parts of large faces have room above them: the floor under a rug, or the wall behind a bookcase, gets no light
// and must not take part in what the rest of the face receives and sends.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/vec.h"
#include "scene/scene.h"

namespace gg {

class Control;
class RayTracer;

// A node of the quadtree over one side of a face, see quarter.h.
struct Patch {
    float exposure = 1;                 // 0..1, mean by area
    std::uint32_t first_child = kNone;  // four in a row, or none
};

// What shares out light from near over the patches of an element.
[[nodiscard]] inline float patch_shelter(float exposure) {
    constexpr float kOfCovered = 0.5F;
    return 1.01F - kOfCovered * exposure;
}

struct PatchForest {
    float reach = 0;  // m, of the rays that looked around
    std::vector<Patch> patches;
    std::unordered_map<std::uint64_t, std::uint32_t> roots;  // of faces of which some part is covered

    // kNone for a face that is exposed everywhere, or too small to have been looked at.
    [[nodiscard]] std::uint32_t root(std::uint32_t instance, std::uint32_t triangle, bool back) const;
    [[nodiscard]] bool is_open(std::uint32_t patch) const {
        return patch != kNone && patches[patch].first_child != kNone;
    }
};

// By short rays from the sides that light reaches of all triangles of these instances that are larger than a few times
// `detail`, which is the size of the smallest patches, m.
[[nodiscard]] PatchForest find_patches(const Scene& scene, std::span<const std::uint32_t> instances, float detail,
                                       const RayTracer& tracer, const Control& control);

}  // namespace gg
