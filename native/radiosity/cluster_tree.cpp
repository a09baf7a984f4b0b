#include "radiosity/cluster_tree.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "core/control.h"

namespace gg {

namespace {

constexpr int kBins = 16;
constexpr int kFanOut = 4;
constexpr float kLargeItem = 0.5F;  // share of the node's diameter from which an item is the node's own

struct Range {
    std::uint32_t begin, end;
    [[nodiscard]] std::uint32_t size() const { return end - begin; }
};

class Builder {
  public:
    Builder(std::span<const Box> items, std::uint32_t leaf_size, const Control& control)
        : items_(items), leaf_size_(leaf_size), control_(control) {}

    ClusterTree run() {
        tree_.order.resize(items_.size());
        std::iota(tree_.order.begin(), tree_.order.end(), 0U);
        tree_.nodes.push_back({bounds_of({0, static_cast<std::uint32_t>(items_.size())}), 0, 0, 0, 0,
                               static_cast<std::uint32_t>(items_.size())});
        for (std::size_t node = 0; node < tree_.nodes.size(); ++node) {
            if (node % 1024 == 0) {
                control_.check_cancel();
            }
            split(node);
        }
        return std::move(tree_);
    }

  private:
    Box bounds_of(Range range) const {
        Box box;
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            box.extend(items_[tree_.order[i]]);
        }
        return box;
    }

    void split(std::size_t node) {
        const Range all{tree_.nodes[node].begin, tree_.nodes[node].end};
        const float large = kLargeItem * tree_.nodes[node].bounds.diameter();
        const auto order = tree_.order.begin();
        const auto small_begin = std::stable_partition(
            order + all.begin, order + all.end, [&](std::uint32_t item) { return items_[item].diameter() > large; });
        const Range large_items{all.begin, static_cast<std::uint32_t>(small_begin - order)};
        const Range rest{large_items.end, all.end};
        const bool like_size = rest.size() == 0 || large_items.size() == 0;
        if (like_size && all.size() <= leaf_size_) {
            tree_.nodes[node].direct_end = all.end;
            return;
        }

        std::array<Range, kFanOut> groups{like_size ? all : rest};
        int count = 1;
        tree_.nodes[node].direct_end = groups[0].begin;
        if (!like_size && large_items.size() > leaf_size_) {
            tree_.nodes[node].direct_end = all.begin;
            groups[count++] = large_items;
        }
        while (count < kFanOut) {
            const auto largest = std::max_element(groups.begin(), groups.begin() + count,
                                                  [](Range a, Range b) { return a.size() < b.size(); });
            // A node whose items all stay together would repeat itself for ever: split it at least once.
            if (largest->size() <= leaf_size_ && !(count == 1 && like_size)) {
                break;
            }
            const std::uint32_t middle = split_range(*largest);
            groups[count++] = {middle, largest->end};
            largest->end = middle;
        }
        std::sort(groups.begin(), groups.begin() + count, [](Range a, Range b) { return a.begin < b.begin; });
        tree_.nodes[node].first_child = static_cast<std::uint32_t>(tree_.nodes.size());
        tree_.nodes[node].child_count = static_cast<std::uint32_t>(count);
        for (int g = 0; g < count; ++g) {
            tree_.nodes.push_back({bounds_of(groups[g]), 0, 0, groups[g].begin, 0, groups[g].end});
        }
    }

    // Reorders the range and returns where its second part begins; both parts have items.
    std::uint32_t split_range(Range range) {
        Box centers;
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            centers.extend(items_[tree_.order[i]].center());
        }
        const Vec3 extent = centers.extent();
        const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : (extent.y >= extent.z ? 1 : 2);
        const auto begin = tree_.order.begin() + range.begin;
        const auto end = tree_.order.begin() + range.end;
        if (extent[axis] > 0) {
            const float scale = kBins / extent[axis];
            const auto bin_of = [&](std::uint32_t item) {
                return std::min(kBins - 1,
                                static_cast<int>((items_[item].center()[axis] - centers.lower[axis]) * scale));
            };
            const int bin = best_split(range, bin_of);
            if (bin > 0) {
                const auto middle =
                    std::stable_partition(begin, end, [&](std::uint32_t item) { return bin_of(item) < bin; });
                return static_cast<std::uint32_t>(middle - tree_.order.begin());
            }
        }
        return range.begin + range.size() / 2;
    }

    // First bin of the second part with the least surface area heuristic, or 0 when all share one bin.
    template <typename BinOf>
    int best_split(Range range, const BinOf& bin_of) const {
        std::array<Box, kBins> boxes;
        std::array<std::uint32_t, kBins> counts{};
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            const int bin = bin_of(tree_.order[i]);
            boxes[bin].extend(items_[tree_.order[i]]);
            ++counts[bin];
        }
        const auto half_area = [](const Box& box) {
            const Vec3 e = box.extent();
            return box.empty() ? 0.0F : e.x * e.y + e.y * e.z + e.z * e.x;
        };
        std::array<float, kBins> cost_right{};
        Box box;
        std::uint32_t count = 0;
        for (int bin = kBins - 1; bin > 0; --bin) {
            box.extend(boxes[bin]);
            count += counts[bin];
            cost_right[bin] = half_area(box) * static_cast<float>(count);
        }
        int best = 0;
        float best_cost = kInfinity;
        box = {};
        count = 0;
        for (int bin = 1; bin < kBins; ++bin) {
            box.extend(boxes[bin - 1]);
            count += counts[bin - 1];
            const float cost = half_area(box) * static_cast<float>(count) + cost_right[bin];
            if (count > 0 && count < range.size() && cost < best_cost) {
                best = bin;
                best_cost = cost;
            }
        }
        return best;
    }

    std::span<const Box> items_;
    std::uint32_t leaf_size_;
    const Control& control_;
    ClusterTree tree_;
};

}  // namespace

ClusterTree build_cluster_tree(std::span<const Box> items, std::uint32_t leaf_size, const Control& control) {
    return Builder(items, leaf_size, control).run();
}

}  // namespace gg
