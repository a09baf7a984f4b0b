// The hierarchy of senders and receivers as far as the solve has opened it.
//
//   geometry            lamps      sky cells         node 0 is the geometry's root, then every lamp, then the sky
//   instances ...
//   clusters of an instance's triangles ...
//   elements: a triangle's side, then quadtrees below it
//
// Nodes lie in one flat array; children are contiguous and come after their parent, so a forward loop pushes and a
// backward loop pulls. Opening a node changes no other node's id.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"
#include "radiosity/faces.h"
#include "transport/sky_cell.h"

namespace gg {

class Control;
class SurfaceColors;

using NodeId = std::uint32_t;
inline constexpr NodeId kGeometryRoot = 0;

enum class NodeKind : std::uint8_t { kInstances, kCluster, kElement, kLamp, kSky };

struct Node {
    NodeKind kind = NodeKind::kCluster;
    bool back = false;              // kElement: of which side
    std::uint8_t depth = 0;         // kElement: quadtree levels below the triangle
    std::uint32_t child_count = 0;  // of an opened node; 0: a leaf, as yet
    NodeId parent = kNone;
    NodeId first_child = 0;
    std::uint32_t instance = kNone;  // kCluster, kElement
    std::uint32_t source = 0;        // kInstances: node of SceneFaces::instances; kCluster: node of its mesh's tree;
                                     // kElement: triangle; kLamp: lamp; kSky: packed cell
    std::uint64_t stable_id = 0;     // the same in every frame; seeds every random choice
    Vec3 center{0.0F};               // of the bounding sphere; kSky: middle direction
    float radius = 0;                // of the bounding sphere, m; lamps: of the lamp; kSky: of the cell in rad
    Vec3 normal{0.0F};               // kElement: unit, of the receiving side
    float area = 0;                  // m2, every face with each of its lit sides; kSky: solid angle
    // Mean exposure by area. What arrives at the node is shared out: a face gets it times its own exposure over this,
    // and light from within the cluster times its own shelter (1 - exposure) over the mean shelter.
    float exposure = 1;
    float weight = 1;               // kElement: its own exposure, by which it gets what arrives at its parent
    float shelter = 0;              // kElement: of a whole triangle: its own
    std::uint32_t patch = kNone;    // kElement: of SceneFaces::patches, as long as its quarters have patches too
    std::array<Vec3, 3> corner{};   // kElement: world; others: [0], [1] the box
    std::array<Vec2, 3> weights{};  // kElement: of corners 1 and 2 of the triangle, at this element's corners
    Rgb reflectance{0.0F};          // mean over the faces
    Rgb emission{0.0F};  // radiosity that it emits by itself, mean over the faces, W/m2 (lamps: see make_lamp)
};

[[nodiscard]] inline bool is_surface(const Node& node) {
    return node.kind <= NodeKind::kElement;
}
[[nodiscard]] inline bool is_cluster(const Node& node) {
    return node.kind <= NodeKind::kCluster;
}

[[nodiscard]] SkyCell sky_cell_of(const Node& node);

class Hierarchy {
  public:
    Hierarchy(const Scene& scene, const SurfaceColors& colors, SceneFaces faces);

    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] const SceneFaces& faces() const { return faces_; }
    [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
    [[nodiscard]] const Node& operator[](NodeId id) const { return nodes_[id]; }
    [[nodiscard]] bool has_geometry() const { return !faces_.instances.nodes.empty(); }
    // m, farther than which no geometry lies from a point.
    [[nodiscard]] float extent_from(Vec3 point) const { return length(nodes_[0].center - point) + nodes_[0].radius; }
    // Lamps and sky cells, present from the start.
    [[nodiscard]] const std::vector<NodeId>& infinite_and_lamps() const { return senders_; }

    // Gives children to leaves, in the order of `leaves` (ascending ids), and to elements among them that are exposed
    // in part, down to the patches. Lamps have none.
    void open(std::span<const NodeId> leaves, const Control& control);
    // Nodes of one generation have no parent in the same generation: [begin, end) of generation g.
    [[nodiscard]] std::span<const NodeId> generations() const { return generations_; }

    // Instances or triangles of a cluster, in the tree's order.
    [[nodiscard]] const ClusterTree::Node& tree_node(const Node& node) const {
        return node.kind == NodeKind::kInstances
                   ? faces_.instances.nodes[node.source]
                   : faces_.meshes[scene_.instances[node.instance].mesh].tree.nodes[node.source];
    }
    [[nodiscard]] bool contains(const Node& cluster, std::uint32_t instance, std::uint32_t triangle) const;

    // body(instance, triangle) for every triangle below a kInstances or kCluster node, or for every stride-th.
    template <typename Body>
    void for_each_triangle(const Node& node, const Body& body, std::uint32_t stride = 1) const;
    [[nodiscard]] std::size_t triangle_count(const Node& cluster) const;

    [[nodiscard]] std::size_t bytes() const { return nodes_.capacity() * sizeof(Node); }

  private:
    [[nodiscard]] Node make_instances(std::uint32_t tree_node, NodeId parent) const;
    [[nodiscard]] Node make_cluster(std::uint32_t instance, std::uint32_t tree_node, NodeId parent) const;
    [[nodiscard]] Node make_element(std::uint32_t instance, std::uint32_t triangle, bool back, NodeId parent) const;
    [[nodiscard]] Node make_quarter(NodeId parent, int quarter) const;
    [[nodiscard]] Node make_lamp(std::uint32_t lamp) const;
    [[nodiscard]] Node make_sky(SkyCell cell, NodeId parent, std::uint64_t stable_id) const;
    void list_children(NodeId id, std::vector<Node>& children) const;
    void list_item_children(NodeId id, std::vector<Node>& children) const;

    const Scene& scene_;
    const SurfaceColors& colors_;
    SceneFaces faces_;
    std::vector<Node> nodes_;
    std::vector<NodeId> senders_;
    std::vector<NodeId> generations_;  // begins, and the end of the last
};

template <typename Body>
void Hierarchy::for_each_triangle(const Node& node, const Body& body, std::uint32_t stride) const {
    const ClusterTree::Node& range = tree_node(node);
    if (node.kind == NodeKind::kCluster) {
        const auto& order = faces_.meshes[scene_.instances[node.instance].mesh].tree.order;
        for (std::uint32_t i = range.begin; i < range.end; i += stride) {
            body(node.instance, order[i]);
        }
        return;
    }
    std::uint32_t skipped = 0;
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
        const std::uint32_t instance = faces_.instance_ids[faces_.instances.order[i]];
        const auto count = static_cast<std::uint32_t>(scene_.meshes[scene_.instances[instance].mesh].triangles.size());
        std::uint32_t triangle = skipped;
        for (; triangle < count; triangle += stride) {
            body(instance, triangle);
        }
        skipped = triangle - count;
    }
}

}  // namespace gg
