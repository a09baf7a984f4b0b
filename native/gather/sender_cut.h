// The senders of a place: links that arrive at what is there, and at all that contains it, made disjoint.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"
#include "radiosity/solution.h"

namespace gg {

// Where a cut is wanted.
struct CutPlace {
    std::span<const NodeId> receivers;  // leaf elements and clusters
    Box bounds;                         // of the points that will use it
    float irradiance = 0;               // W/m2 there, about, luminance: what counts
};

struct CutSender {
    NodeId sender = kNone;
    float visibility = 0;  // 0..1, as links know it
    float occluder = 0;    // m from the receivers, the farthest that links know of; 0: none
};

// Disjoint: no sender is an ancestor of another, and of every linked sender each part is covered once.
struct SenderCut {
    std::vector<CutSender> senders;
    std::vector<NodeId> near;  // clusters too close for that: whoever looks around meets their faces
};

// Makes cuts, one after the other; for one thread.
class CutBuilder {
  public:
    explicit CutBuilder(const Solution& solution);

    // Of the links of all receivers and their ancestors the finest wins. Senders are opened further where they are
    // close or uneven; what is then still close and a cluster is near.
    void build(const CutPlace& place, SenderCut& cut);

  private:
    struct Mark {
        std::uint32_t stamp = 0;
        bool linked = false, near = false, above_linked = false;
        float visibility = 0, weight = 0, occluder = 0;
    };
    struct Cover {
        bool covered = false, near = false;
        float visibility = 0, occluder = 0;
    };

    Mark& mark(NodeId node);
    void add_links_to(NodeId receiver);
    void descend(NodeId node, Cover cover, const CutPlace& place, SenderCut& cut);
    [[nodiscard]] bool is_close(const Node& node, const CutPlace& place) const;
    [[nodiscard]] bool should_open(NodeId id, const CutPlace& place) const;

    const Solution& solution_;
    const Hierarchy& hierarchy_;
    std::vector<Mark> marks_;             // per node; valid if stamp_ is theirs
    std::vector<std::uint32_t> visited_;  // per node: receivers, by stamp
    std::vector<NodeId> roots_;           // marked nodes without parents
    std::uint32_t stamp_ = 0;
};

}  // namespace gg
