// Neighbouring faces of a mesh that lie alike: they are looked at as one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "radiosity/cluster_tree.h"
#include "scene/scene.h"

namespace gg {

class Control;

struct FaceSide {
    std::uint32_t triangle = 0;
    bool back = false;
};

// A partition of the sides that light reaches.
struct FaceGroups {
    std::vector<FaceSide> sides;                   // group after group
    std::vector<std::uint32_t> begin{0};           // of every group in `sides`, and the end
    std::vector<std::uint32_t> of_front, of_back;  // triangle -> group, or kNone

    [[nodiscard]] std::size_t count() const { return begin.size() - 1; }
    [[nodiscard]] std::span<const FaceSide> operator[](std::size_t group) const {
        return std::span(sides).subspan(begin[group], begin[group + 1] - begin[group]);
    }
    [[nodiscard]] std::uint32_t of(std::uint32_t triangle, bool back) const {
        return (back ? of_back : of_front)[triangle];
    }

    // Groups on their way into one list.
    struct Builder {
        std::vector<FaceSide> sides;
        std::vector<std::uint32_t> ends;  // of every group in `sides`

        void add(std::span<const FaceSide> group) {
            sides.insert(sides.end(), group.begin(), group.end());
            ends.push_back(static_cast<std::uint32_t>(sides.size()));
        }
    };
};

// The groups of all parts in their order, over a mesh of so many triangles.
[[nodiscard]] FaceGroups make_groups(std::span<const FaceGroups::Builder> parts, std::size_t triangles);

// Of one placed instance, which stands for all instances of its mesh; `tree` holds all its triangles. A group lies
// within one of the tree's small nodes. scene_size: diameter of all that light reaches, m.
[[nodiscard]] FaceGroups group_faces(const Scene& scene, std::uint32_t instance, const ClusterTree& tree,
                                     float scene_size, const Control& control);

}  // namespace gg
