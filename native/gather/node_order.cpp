#include "gather/node_order.h"

namespace gg {

NodeOrder::NodeOrder(const Hierarchy& hierarchy) : ranges_(hierarchy.nodes().size()) {
    const auto& nodes = hierarchy.nodes();
    std::vector<std::uint32_t> sizes(nodes.size(), 1);
    for (NodeId id = static_cast<NodeId>(nodes.size()); id-- > 0;) {
        if (nodes[id].parent != kNone) {
            sizes[nodes[id].parent] += sizes[id];
        }
    }
    std::uint32_t next = 0;
    for (NodeId id = 0; id < nodes.size(); ++id) {
        if (nodes[id].parent == kNone) {
            ranges_[id] = {next, next + sizes[id]};
            next += sizes[id];
        }
        std::uint32_t begin = ranges_[id].begin + 1;
        for (NodeId child = nodes[id].first_child; child < nodes[id].first_child + nodes[id].child_count; ++child) {
            ranges_[child] = {begin, begin + sizes[child]};
            begin += sizes[child];
        }
    }
}

}  // namespace gg
