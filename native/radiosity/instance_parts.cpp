#include "radiosity/instance_parts.h"

namespace gg {

std::vector<InstanceParts> parts_of_instances(const Hierarchy& hierarchy) {
    std::vector<InstanceParts> parts(hierarchy.scene().instances.size());
    const auto& nodes = hierarchy.nodes();
    for (NodeId id = 0; id < nodes.size(); ++id) {
        const Node& node = nodes[id];
        if (node.kind == NodeKind::kElement && node.depth == 0) {
            parts[node.instance].element_roots.push_back(id);
        } else if (is_cluster(node) && node.child_count == 0 && hierarchy.has_geometry()) {
            if (node.kind == NodeKind::kCluster) {
                parts[node.instance].leaf_clusters.push_back(id);
                continue;
            }
            const ClusterTree::Node& range = hierarchy.tree_node(node);
            for (std::uint32_t i = range.begin; i < range.end; ++i) {
                const std::uint32_t item = hierarchy.faces().instances.order[i];
                parts[hierarchy.faces().instance_ids[item]].leaf_clusters.push_back(id);
            }
        }
    }
    return parts;
}

ElementTable find_elements(const Hierarchy& hierarchy) {
    const Scene& scene = hierarchy.scene();
    ElementTable elements;
    elements.front.resize(scene.instances.size());
    elements.back.resize(scene.instances.size());
    for (NodeId id = 0; id < hierarchy.nodes().size(); ++id) {
        const Node& node = hierarchy[id];
        if (node.kind == NodeKind::kElement && node.depth == 0) {
            std::vector<NodeId>& table = (node.back ? elements.back : elements.front)[node.instance];
            table.resize(scene.meshes[scene.instances[node.instance].mesh].triangles.size(), kNone);
            table[node.source] = id;
        }
    }
    return elements;
}

ClusterTable find_clusters(const Hierarchy& hierarchy) {
    const Scene& scene = hierarchy.scene();
    const auto parts = parts_of_instances(hierarchy);
    ClusterTable table;
    table.clusters.resize(parts.size());
    for (std::uint32_t i = 0; i < parts.size(); ++i) {
        for (const NodeId leaf : parts[i].leaf_clusters) {
            table.clusters[i].resize(scene.meshes[scene.instances[i].mesh].triangles.size(), kNone);
            for_each_triangle_in(hierarchy, leaf, i, [&](std::uint32_t t) { table.clusters[i][t] = leaf; });
        }
    }
    return table;
}

}  // namespace gg
