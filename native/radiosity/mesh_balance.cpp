#include "radiosity/mesh_balance.h"

#include <algorithm>
#include <vector>

#include "core/parallel.h"
#include "radiosity/instance_parts.h"
#include "radiosity/t_vertices.h"

namespace gg {

namespace {

// The elements of one instance.
class Balancer {
  public:
    Balancer(const Hierarchy& hierarchy, const Mesh& mesh) : hierarchy_(hierarchy), mesh_(mesh) {}

    void find_midpoints(const std::vector<NodeId>& roots) {
        for (const NodeId root : roots) {
            divide(root, mesh_.shading_vertices[hierarchy_[root].source], [](NodeId, const Corners&) {});
        }
    }

    // Leaves with an edge that is divided twice.
    void list_coarse(const std::vector<NodeId>& roots, std::vector<NodeId>& out) {
        for (const NodeId root : roots) {
            divide(root, mesh_.shading_vertices[hierarchy_[root].source], [&](NodeId leaf, const Corners& corners) {
                for (int k = 0; k < 3; ++k) {
                    if (is_divided_twice(corners[k], corners[(k + 1) % 3])) {
                        out.push_back(leaf);
                        return;
                    }
                }
            });
        }
    }

  private:
    template <typename Body>
    void divide(NodeId id, const Corners& corners, const Body& body) {
        const Node& node = hierarchy_[id];
        if (node.child_count == 0) {
            body(id, corners);
            return;
        }
        const Corners opposite = make_midpoints(midpoints_, mesh_.normals.size(), corners);
        for (int quarter = 0; quarter < 4; ++quarter) {
            divide(node.first_child + quarter, quarter_corners(corners, opposite, quarter), body);
        }
    }

    [[nodiscard]] bool is_divided_twice(std::uint32_t a, std::uint32_t b) const {
        const auto middle = midpoints_.find(edge_key(a, b));
        return middle != midpoints_.end() &&
               (midpoints_.contains(edge_key(a, middle->second)) || midpoints_.contains(edge_key(middle->second, b)));
    }

    const Hierarchy& hierarchy_;
    const Mesh& mesh_;
    Midpoints midpoints_;
};

bool has_divided(const Hierarchy& hierarchy, const std::vector<NodeId>& roots) {
    return std::any_of(roots.begin(), roots.end(), [&](NodeId root) { return hierarchy[root].child_count > 0; });
}

std::vector<NodeId> coarse_elements(const Hierarchy& hierarchy, std::uint32_t instance,
                                    const std::vector<NodeId>& roots) {
    const Scene& scene = hierarchy.scene();
    Balancer balancer(hierarchy, scene.meshes[scene.instances[instance].mesh]);
    std::vector<NodeId> found;
    balancer.find_midpoints(roots);
    balancer.list_coarse(roots, found);
    return found;
}

}  // namespace

void balance_elements(Hierarchy& hierarchy, Lighting& lighting, const Control& control) {
    constexpr int kMostRounds = 16;
    const auto parts = parts_of_instances(hierarchy);
    std::vector<std::uint32_t> uneven;  // instances
    for (std::uint32_t i = 0; i < parts.size(); ++i) {
        if (has_divided(hierarchy, parts[i].element_roots)) {
            uneven.push_back(i);
        }
    }
    for (int round = 0; round < kMostRounds && !uneven.empty(); ++round) {
        std::vector<std::vector<NodeId>> coarse(uneven.size());
        parallel_for(uneven.size(), 1, control, [&](std::size_t k) {
            coarse[k] = coarse_elements(hierarchy, uneven[k], parts[uneven[k]].element_roots);
        });
        std::vector<NodeId> opened;
        std::vector<std::uint32_t> still_uneven;
        for (std::size_t k = 0; k < uneven.size(); ++k) {
            if (!coarse[k].empty()) {
                still_uneven.push_back(uneven[k]);
                opened.insert(opened.end(), coarse[k].begin(), coarse[k].end());
            }
        }
        std::sort(opened.begin(), opened.end());
        hierarchy.open(opened, control);
        lighting.grow(control);
        uneven = std::move(still_uneven);
    }
}

}  // namespace gg
