#include "scene/enclosing.h"

#include <algorithm>
#include <numeric>

#include "core/control.h"
#include "core/parallel.h"

namespace gg {

namespace {

constexpr std::size_t kLeafSize = 4;

// A balanced tree over boxes, split at the median of centres. A node keeps the range of its boxes' lower and of their
// upper corners: that bounds from both sides what a query box must hold.
class BoxTree {
  public:
    explicit BoxTree(std::span<const Box> boxes) : boxes_(boxes), order_(boxes.size()) {
        std::iota(order_.begin(), order_.end(), 0U);
        nodes_.reserve(boxes.size());
        if (!boxes.empty()) {
            build(0, order_.size());
        }
    }

    [[nodiscard]] bool holds_another(std::uint32_t query) const { return search(0, query); }

  private:
    struct Node {
        Box lowers, uppers;  // of the corners
        std::uint32_t begin = 0, end = 0;
        std::uint32_t second = 0;  // child; the first one follows the node; 0: leaf
    };

    std::uint32_t build(std::size_t begin, std::size_t end) {
        const auto index = static_cast<std::uint32_t>(nodes_.size());
        Node node;
        node.begin = static_cast<std::uint32_t>(begin);
        node.end = static_cast<std::uint32_t>(end);
        Box centers;
        for (std::size_t at = begin; at < end; ++at) {
            const Box& box = boxes_[order_[at]];
            node.lowers.extend(box.lower);
            node.uppers.extend(box.upper);
            centers.extend(box.center());
        }
        nodes_.push_back(node);
        if (end - begin > kLeafSize) {
            const Vec3 extent = centers.extent();
            const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : (extent.y >= extent.z ? 1 : 2);
            const std::size_t middle = (begin + end) / 2;
            const auto first = order_.begin();
            std::nth_element(first + static_cast<std::ptrdiff_t>(begin), first + static_cast<std::ptrdiff_t>(middle),
                             first + static_cast<std::ptrdiff_t>(end), [&](std::uint32_t a, std::uint32_t b) {
                                 return boxes_[a].center()[axis] < boxes_[b].center()[axis];
                             });
            build(begin, middle);
            nodes_[index].second = build(middle, end);
        }
        return index;
    }

    [[nodiscard]] bool search(std::uint32_t index, std::uint32_t query) const {
        const Node& node = nodes_[index];
        const Box& box = boxes_[query];
        const bool some_may_fit = glm::all(glm::lessThanEqual(box.lower, node.lowers.upper)) &&
                                  glm::all(glm::lessThanEqual(node.uppers.lower, box.upper));
        if (!some_may_fit) {
            return false;
        }
        if (node.end - node.begin > 1 && box.contains(Box{node.lowers.lower, node.uppers.upper})) {
            return true;  // all fit, and one of them at least is another
        }
        if (node.second != 0) {
            return search(index + 1, query) || search(node.second, query);
        }
        return std::any_of(order_.begin() + node.begin, order_.begin() + node.end,
                           [&](std::uint32_t other) { return other != query && box.contains(boxes_[other]); });
    }

    std::span<const Box> boxes_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace

std::vector<std::uint8_t> find_enclosing(std::span<const Box> boxes, std::size_t queried, const Control& control) {
    const BoxTree tree(boxes);
    std::vector<std::uint8_t> result(queried);
    parallel_for(queried, 1024, control, [&](std::size_t query) {
        result[query] = tree.holds_another(static_cast<std::uint32_t>(query)) ? 1 : 0;
    });
    return result;
}

}  // namespace gg
