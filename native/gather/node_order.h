// Nodes in the order of a walk that visits a node before its children: a subtree is a range of ranks.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "radiosity/solution.h"

namespace gg {

struct RankRange {
    std::uint32_t begin = 0, end = 0;

    friend bool operator<(const RankRange& a, const RankRange& b) { return a.begin < b.begin; }
};

class NodeOrder {
  public:
    explicit NodeOrder(const Hierarchy& hierarchy);

    [[nodiscard]] std::uint32_t rank(NodeId node) const { return ranges_[node].begin; }
    // Of the node and all below it.
    [[nodiscard]] RankRange range(NodeId node) const { return ranges_[node]; }
    [[nodiscard]] std::size_t bytes() const { return ranges_.capacity() * sizeof(RankRange); }

  private:
    std::vector<RankRange> ranges_;
};

// Whether one of the disjoint, ascending ranges holds the rank.
[[nodiscard]] inline bool holds(std::span<const RankRange> ranges, std::uint32_t rank) {
    const auto after = std::upper_bound(ranges.begin(), ranges.end(), RankRange{rank, rank});
    return after != ranges.begin() && rank < (after - 1)->end;
}

}  // namespace gg
