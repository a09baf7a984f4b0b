#include "gather/sender_cut.h"

#include <algorithm>
#include <cmath>

namespace gg {

namespace {

constexpr float kClose = 1;       // distance in radii within which a cluster is not one thing
constexpr float kUneven = 0.01F;  // share of the irradiance that an uneven sender may bring too much or too little
constexpr float kLarge = 0.7F;    // radius over distance from which an element's unevenness counts in full

}  // namespace

CutBuilder::CutBuilder(const Solution& solution)
    : solution_(solution),
      hierarchy_(hierarchy_of(solution)),
      marks_(hierarchy_.nodes().size()),
      visited_(hierarchy_.nodes().size()) {}

CutBuilder::Mark& CutBuilder::mark(NodeId node) {
    Mark& found = marks_[node];
    if (found.stamp != stamp_) {
        found = {};
        found.stamp = stamp_;
        if (hierarchy_[node].parent == kNone) {
            roots_.push_back(node);
        }
    }
    return found;
}

void CutBuilder::add_links_to(NodeId receiver) {
    const float area = hierarchy_[receiver].area;
    for (const Link& link : links_to(solution_, receiver)) {
        Mark& sender = mark(link.sender);
        sender.linked = true;
        sender.near = sender.near || link.near;
        sender.visibility += area * link.visibility;
        sender.weight += area;
        sender.occluder = std::max(sender.occluder, link.farthest_occluder);
        for (NodeId above = hierarchy_[link.sender].parent; above != kNone; above = hierarchy_[above].parent) {
            Mark& ancestor = mark(above);
            if (ancestor.above_linked) {
                break;
            }
            ancestor.above_linked = true;
        }
    }
}

void CutBuilder::build(const CutPlace& place, SenderCut& cut) {
    cut.senders.clear();
    cut.near.clear();
    roots_.clear();
    ++stamp_;
    for (const NodeId receiver : place.receivers) {
        for (NodeId id = receiver; id != kNone && visited_[id] != stamp_; id = hierarchy_[id].parent) {
            visited_[id] = stamp_;
            add_links_to(id);
        }
    }
    for (const NodeId root : roots_) {
        descend(root, {}, place, cut);
    }
}

bool CutBuilder::is_close(const Node& node, const CutPlace& place) const {
    const Box box{node.corner[0], node.corner[1]};
    const Vec3 gap = glm::max(glm::max(box.lower - place.bounds.upper, place.bounds.lower - box.upper), Vec3(0.0F));
    return length(gap) < kClose * node.radius;
}

bool CutBuilder::should_open(NodeId id, const CutPlace& place) const {
    const Node& node = hierarchy_[id];
    if (node.child_count == 0) {
        return false;
    }
    if (is_cluster(node)) {
        return is_close(node, place);
    }
    if (node.kind != NodeKind::kElement) {
        return false;
    }
    const float distance =
        std::max(length(node.center - place.bounds.center()) - 0.5F * place.bounds.diameter(), 1e-6F);
    const float factor = std::min(1.0F, node.area / (kPi * distance * distance));
    const float size = std::min(1.0F, node.radius / (kLarge * distance));
    return spread_of(solution_, id) * factor * size > kUneven * place.irradiance;
}

void CutBuilder::descend(NodeId id, Cover cover, const CutPlace& place, SenderCut& cut) {
    const Node& node = hierarchy_[id];
    const Mark* found = marks_[id].stamp == stamp_ ? &marks_[id] : nullptr;
    if (found != nullptr && found->linked) {
        cover = {true, found->near, found->visibility / std::max(found->weight, 1e-30F), found->occluder};
    }
    const bool finer = found != nullptr && found->above_linked;
    if (finer || (cover.covered && should_open(id, place))) {
        for (NodeId child = node.first_child; child < node.first_child + node.child_count; ++child) {
            descend(child, cover, place, cut);
        }
    } else if (cover.covered) {
        if (is_cluster(node) && (cover.near || is_close(node, place))) {
            cut.near.push_back(id);
        } else {
            cut.senders.push_back({id, cover.visibility, cover.occluder});
        }
    }
}

}  // namespace gg
