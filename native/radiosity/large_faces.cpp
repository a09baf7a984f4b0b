#include "radiosity/large_faces.h"

#include <algorithm>
#include <vector>

#include "core/parallel.h"

namespace gg {

namespace {

bool has_large_face(const Hierarchy& hierarchy, const Node& cluster, float edge) {
    if (2 * cluster.radius < edge) {
        return false;
    }
    bool found = false;
    hierarchy.for_each_triangle(cluster, [&](std::uint32_t instance, std::uint32_t triangle) {
        const auto c = world_triangle(hierarchy.scene(), instance, triangle);
        const float longest =
            std::max({length_squared(c[1] - c[0]), length_squared(c[2] - c[0]), length_squared(c[2] - c[1])});
        found = found || longest >= edge * edge;
    });
    return found;
}

}  // namespace

void open_large_faces(Hierarchy& hierarchy, Lighting& lighting, float edge, const Control& control) {
    for (NodeId begin = 0; begin < hierarchy.nodes().size() && hierarchy.has_geometry();) {
        const auto end = static_cast<NodeId>(hierarchy.nodes().size());
        const std::vector<NodeId> opened = parallel_collect<NodeId>(
            end - begin, 16, control, [&](std::size_t first, std::size_t last, std::vector<NodeId>& out) {
                for (auto id = static_cast<NodeId>(begin + first); id < begin + last; ++id) {
                    const Node& node = hierarchy[id];
                    if (is_cluster(node) && node.child_count == 0 && has_large_face(hierarchy, node, edge)) {
                        out.push_back(id);
                    }
                }
            });
        hierarchy.open(opened, control);
        lighting.grow(control);
        begin = end;
    }
}

}  // namespace gg
