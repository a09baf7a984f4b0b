#include "radiosity/hierarchy.h"

#include <algorithm>

#include "core/parallel.h"
#include "core/random.h"

namespace gg {

namespace {

constexpr std::uint64_t kGeometrySeed = 0x67656f6d, kSkySeed = 0x736b79;

}  // namespace

SkyCell sky_cell_of(const Node& node) {
    return {node.depth, static_cast<std::uint8_t>(node.back), static_cast<std::uint16_t>(node.source >> 16),
            static_cast<std::uint16_t>(node.source & 0xFFFF)};
}

Hierarchy::Hierarchy(const Scene& scene, const SurfaceColors& colors, SceneFaces faces)
    : scene_(scene), colors_(colors), faces_(std::move(faces)) {
    if (has_geometry()) {
        nodes_.push_back(make_instances(0, kNone));
    } else {
        nodes_.emplace_back();
    }
    nodes_[0].stable_id = hash64(kGeometrySeed);
    for (std::uint32_t lamp = 0; lamp < scene.lamps.size(); ++lamp) {
        senders_.push_back(static_cast<NodeId>(nodes_.size()));
        nodes_.push_back(make_lamp(lamp));
    }
    if (luminance(scene.world) > 0) {
        for (const SkyCell root : sky_roots()) {
            for (const SkyCell cell : children(root)) {
                senders_.push_back(static_cast<NodeId>(nodes_.size()));
                nodes_.push_back(make_sky(cell, kNone, hash64(kSkySeed, senders_.back())));
            }
        }
    }
    generations_ = {0, static_cast<NodeId>(nodes_.size())};
}

void Hierarchy::list_item_children(NodeId id, std::vector<Node>& children) const {
    const Node& node = nodes_[id];
    const ClusterTree::Node& range = tree_node(node);
    const ClusterTree& tree =
        node.kind == NodeKind::kInstances ? faces_.instances : faces_.meshes[scene_.instances[node.instance].mesh].tree;
    const auto add_triangle = [&](std::uint32_t triangle) {
        const Sides sides = scene_.sides_of(node.instance, triangle);
        for (const bool back : {false, true}) {
            if (has_side(sides, back)) {
                children.push_back(make_element(node.instance, triangle, back, id));
            }
        }
    };
    for (std::uint32_t child = range.first_child; child < range.first_child + range.child_count; ++child) {
        const ClusterTree::Node& part = tree.nodes[child];
        if (node.kind == NodeKind::kInstances) {
            children.push_back(make_instances(child, id));
        } else if (part.end == part.begin + 1) {
            add_triangle(tree.order[part.begin]);
        } else {
            children.push_back(make_cluster(node.instance, child, id));
        }
    }
    for (std::uint32_t i = range.begin; i < range.direct_end; ++i) {
        if (node.kind == NodeKind::kInstances) {
            children.push_back(make_cluster(faces_.instance_ids[tree.order[i]], 0, id));
        } else {
            add_triangle(tree.order[i]);
        }
    }
}

void Hierarchy::list_children(NodeId id, std::vector<Node>& out) const {
    const Node& node = nodes_[id];
    switch (node.kind) {
        case NodeKind::kInstances:
        case NodeKind::kCluster:
            list_item_children(id, out);
            break;
        case NodeKind::kElement:
            for (int quarter = 0; quarter < 4; ++quarter) {
                out.push_back(make_quarter(id, quarter));
            }
            break;
        case NodeKind::kLamp:
            break;
        case NodeKind::kSky:
            for (const SkyCell cell : children(sky_cell_of(node))) {
                out.push_back(make_sky(cell, id, hash64(node.stable_id, out.size())));
            }
            break;
    }
}

void Hierarchy::open(std::span<const NodeId> leaves, const Control& control) {
    if (leaves.empty()) {
        return;
    }
    constexpr std::size_t kBlock = 64;
    std::vector<std::vector<Node>> made((leaves.size() + kBlock - 1) / kBlock);
    std::vector<std::uint32_t> counts(leaves.size());
    parallel_blocks(leaves.size(), kBlock, control, [&](std::size_t begin, std::size_t end) {
        std::vector<Node>& block = made[begin / kBlock];
        for (std::size_t i = begin; i < end; ++i) {
            std::vector<Node> children;
            list_children(leaves[i], children);
            counts[i] = static_cast<std::uint32_t>(children.size());
            block.insert(block.end(), children.begin(), children.end());
        }
    });
    auto next = static_cast<NodeId>(nodes_.size());
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        nodes_[leaves[i]].first_child = next;
        nodes_[leaves[i]].child_count = counts[i];
        next += counts[i];
    }
    if (next > nodes_.capacity()) {
        nodes_.reserve(std::max<std::size_t>(next, nodes_.capacity() * 3 / 2));
    }
    const auto first = static_cast<NodeId>(nodes_.size());
    for (const auto& block : made) {
        nodes_.insert(nodes_.end(), block.begin(), block.end());
    }
    generations_.push_back(next);
    std::vector<NodeId> mixed;
    for (NodeId id = first; id < next; ++id) {
        if (nodes_[id].patch != kNone) {
            mixed.push_back(id);
        }
    }
    open(mixed, control);
}

std::size_t Hierarchy::triangle_count(const Node& cluster) const {
    const ClusterTree::Node& range = tree_node(cluster);
    if (cluster.kind == NodeKind::kCluster) {
        return range.end - range.begin;
    }
    std::size_t count = 0;
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
        const std::uint32_t instance = faces_.instance_ids[faces_.instances.order[i]];
        count += scene_.meshes[scene_.instances[instance].mesh].triangles.size();
    }
    return count;
}

bool Hierarchy::contains(const Node& cluster, std::uint32_t instance, std::uint32_t triangle) const {
    const ClusterTree::Node& range = tree_node(cluster);
    if (cluster.kind == NodeKind::kCluster) {
        if (instance != cluster.instance) {
            return false;
        }
        const std::uint32_t rank = faces_.meshes[scene_.instances[instance].mesh].rank[triangle];
        return range.begin <= rank && rank < range.end;
    }
    const std::uint32_t rank = faces_.instance_rank[instance];
    return range.begin <= rank && rank < range.end;
}

}  // namespace gg
