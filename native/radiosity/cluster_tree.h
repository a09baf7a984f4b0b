// A static hierarchy of clusters over boxes: the triangles of a mesh, or the instances of a scene.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"

namespace gg {

class Control;

// Node 0 is the root; children are contiguous and come after their parent. The items of a node's whole subtree are
// order[begin, end); those that hang off the node itself are order[begin, direct_end).
struct ClusterTree {
    struct Node {
        Box bounds;
        std::uint32_t first_child = 0, child_count = 0;
        std::uint32_t begin = 0, direct_end = 0, end = 0;
    };
    std::vector<Node> nodes;
    std::vector<std::uint32_t> order;
};

// Items larger than half a node hang off the node itself, or are split apart when they are many, so that a cluster
// never mixes them with far smaller ones [Sillion 1995]; the rest is split by the binned surface area heuristic into up
// to four children. Nodes with at most `leaf_size` items of like size are not split. At least one item.
[[nodiscard]] ClusterTree build_cluster_tree(std::span<const Box> items, std::uint32_t leaf_size,
                                             const Control& control);

}  // namespace gg
