// What the hierarchy made of every instance: elements, and clusters that were not opened.
#pragma once

#include <vector>

#include "radiosity/hierarchy.h"

namespace gg {

struct InstanceParts {
    std::vector<NodeId> element_roots;  // of a whole side of a triangle
    std::vector<NodeId> leaf_clusters;  // which hold faces of the instance, or all of it
};

// Per instance; empty for those that light does not reach.
[[nodiscard]] std::vector<InstanceParts> parts_of_instances(const Hierarchy& hierarchy);

// The element of a whole side of a triangle.
struct ElementTable {
    std::vector<std::vector<NodeId>> front, back;  // per instance, empty or per triangle

    // kNone where the triangle stayed in a cluster.
    [[nodiscard]] NodeId of(std::uint32_t instance, std::uint32_t triangle, bool on_back) const {
        const std::vector<NodeId>& table = (on_back ? back : front)[instance];
        return table.empty() ? kNone : table[triangle];
    }
};

[[nodiscard]] ElementTable find_elements(const Hierarchy& hierarchy);

// The leaf cluster of a triangle.
struct ClusterTable {
    std::vector<std::vector<NodeId>> clusters;  // per instance, empty or per triangle

    // kNone where the triangle has become elements.
    [[nodiscard]] NodeId of(std::uint32_t instance, std::uint32_t triangle) const {
        const std::vector<NodeId>& table = clusters[instance];
        return table.empty() ? kNone : table[triangle];
    }
};

[[nodiscard]] ClusterTable find_clusters(const Hierarchy& hierarchy);

// body(triangle) for every triangle of the instance in one of its leaf clusters.
template <typename Body>
void for_each_triangle_in(const Hierarchy& hierarchy, NodeId leaf_cluster, std::uint32_t instance, const Body& body) {
    if (hierarchy[leaf_cluster].kind == NodeKind::kCluster) {
        hierarchy.for_each_triangle(hierarchy[leaf_cluster], [&](std::uint32_t, std::uint32_t t) { body(t); });
        return;
    }
    const Scene& scene = hierarchy.scene();
    const auto count = static_cast<std::uint32_t>(scene.meshes[scene.instances[instance].mesh].triangles.size());
    for (std::uint32_t triangle = 0; triangle < count; ++triangle) {
        body(triangle);
    }
}

}  // namespace gg
