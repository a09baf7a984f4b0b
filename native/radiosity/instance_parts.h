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
