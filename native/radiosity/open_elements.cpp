#include "radiosity/open_elements.h"

#include <cstdint>
#include <vector>

#include "core/parallel.h"
#include "radiosity/oracle.h"

namespace gg {

namespace {

constexpr int kMostRounds = 8;
constexpr std::size_t kElementsAtOnce = 64;

// Leaf elements from `begin` on.
std::vector<NodeId> splittable_elements(const Hierarchy& hierarchy, NodeId begin, const RefineSettings& settings) {
    std::vector<NodeId> found;
    for (NodeId id = begin; id < hierarchy.nodes().size(); ++id) {
        const Node& node = hierarchy[id];
        if (node.kind == NodeKind::kElement && node.child_count == 0 && can_split(node, settings) && node.weight > 0) {
            found.push_back(id);
        }
    }
    return found;
}

}  // namespace

void open_elements(Hierarchy& hierarchy, Lighting& lighting, const RefineSettings& settings,
                   const std::function<ElementTest()>& make_test, const Control& control) {
    NodeId begin = 0;
    for (int round = 0; round < kMostRounds; ++round) {
        const std::vector<NodeId> candidates = splittable_elements(hierarchy, begin, settings);
        std::vector<std::uint8_t> passed(candidates.size());
        parallel_blocks(candidates.size(), kElementsAtOnce, control, [&](std::size_t first, std::size_t end) {
            const ElementTest test = make_test();
            for (std::size_t i = first; i < end; ++i) {
                passed[i] = test(candidates[i]);
            }
        });
        std::vector<NodeId> opened;
        for (std::size_t i = 0; i < candidates.size(); ++i) {
            if (passed[i]) {
                opened.push_back(candidates[i]);
            }
        }
        if (opened.empty()) {
            return;
        }
        begin = static_cast<NodeId>(hierarchy.nodes().size());
        hierarchy.open(opened, control);
        lighting.grow(control);
    }
}

}  // namespace gg
