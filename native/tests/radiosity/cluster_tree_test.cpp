#include "radiosity/cluster_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <vector>

#include "core/control.h"
#include "core/random.h"

namespace gg {
namespace {

std::vector<Box> random_boxes(std::uint32_t count, float smallest, float largest) {
    std::vector<Box> boxes;
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto number = [&](std::uint64_t dimension) { return unit_float(hash64(i, dimension)); };
        const Vec3 lower = 10.0F * Vec3(number(0), number(1), number(2));
        const float size = smallest * std::pow(largest / smallest, number(3));
        boxes.push_back({lower, lower + size * Vec3(number(4), number(5), number(6))});
    }
    return boxes;
}

void expect_well_formed(const ClusterTree& tree, const std::vector<Box>& items) {
    auto sorted = tree.order;
    std::sort(sorted.begin(), sorted.end());
    std::vector<std::uint32_t> all(items.size());
    std::iota(all.begin(), all.end(), 0U);
    ASSERT_EQ(sorted, all);
    ASSERT_EQ(tree.nodes[0].begin, 0U);
    ASSERT_EQ(tree.nodes[0].end, items.size());
    std::vector<int> parents(tree.nodes.size());
    for (std::uint32_t id = 0; id < tree.nodes.size(); ++id) {
        const ClusterTree::Node& node = tree.nodes[id];
        ASSERT_LT(node.begin, node.end);
        ASSERT_LE(node.direct_end, node.end);
        for (std::uint32_t i = node.begin; i < node.end; ++i) {
            ASSERT_TRUE(node.bounds.contains(items[tree.order[i]]));
        }
        // What hangs off the node itself, then child by child.
        std::uint32_t next = node.direct_end;
        for (std::uint32_t child = node.first_child; child < node.first_child + node.child_count; ++child) {
            ASSERT_GT(child, id);
            ASSERT_EQ(tree.nodes[child].begin, next);
            ASSERT_TRUE(node.bounds.contains(tree.nodes[child].bounds));
            ++parents[child];
            next = tree.nodes[child].end;
        }
        ASSERT_EQ(next, node.end);
    }
    EXPECT_EQ(parents[0], 0);
    EXPECT_TRUE(std::all_of(parents.begin() + 1, parents.end(), [](int count) { return count == 1; }));
}

ClusterTree build(const std::vector<Box>& boxes, std::uint32_t leaf_size) {
    return build_cluster_tree(boxes, leaf_size, Control{});
}

TEST(ClusterTree, holds_every_item_once_and_children_partition_their_parent) {
    for (const std::uint32_t count : {1U, 2U, 7U, 8U, 9U, 100U, 3000U}) {
        for (const std::uint32_t leaf_size : {1U, 8U}) {
            const auto boxes = random_boxes(count, 0.01F, 1);
            expect_well_formed(build(boxes, leaf_size), boxes);
        }
    }
}

TEST(ClusterTree, divides_down_to_the_leaf_size) {
    const auto boxes = random_boxes(3000, 0.01F, 0.01F);
    for (const ClusterTree::Node& node : build(boxes, 8).nodes) {
        EXPECT_LE(node.direct_end - node.begin, 8U);
        EXPECT_TRUE(node.child_count == 0 || node.child_count >= 2);
    }
}

// An item larger than half of a node never lies in one child with items that are far smaller than it.
TEST(ClusterTree, keeps_large_items_out_of_clusters_of_small_ones) {
    auto boxes = random_boxes(2000, 0.02F, 0.05F);
    boxes.push_back({{0, 0, 0}, {10, 10, 0}});
    boxes.push_back({{2, 2, 2}, {6, 6, 6}});
    const ClusterTree tree = build(boxes, 8);
    expect_well_formed(tree, boxes);
    for (const ClusterTree::Node& node : tree.nodes) {
        float least = kInfinity, most = 0;
        for (std::uint32_t i = node.direct_end; i < node.end; ++i) {
            least = std::min(least, boxes[tree.order[i]].diameter());
            most = std::max(most, boxes[tree.order[i]].diameter());
        }
        if (node.child_count > 0 && most > 0.5F * node.bounds.diameter()) {
            EXPECT_GT(least, 0.2F * most);
        }
    }
    EXPECT_EQ(tree.order[0], 2000U);
    EXPECT_EQ(tree.nodes[0].direct_end, 1U);
}

TEST(ClusterTree, survives_items_that_cannot_be_told_apart) {
    const std::vector<Box> equal(1000, Box{{1, 2, 3}, {2, 3, 4}});
    expect_well_formed(build(equal, 8), equal);
    const std::vector<Box> points(1000, Box{{1, 2, 3}, {1, 2, 3}});
    expect_well_formed(build(points, 1), points);
    std::vector<Box> nested;
    for (int i = 0; i < 200; ++i) {
        nested.push_back({Vec3(-1.0F - static_cast<float>(i)), Vec3(1.0F + static_cast<float>(i))});
    }
    expect_well_formed(build(nested, 4), nested);
}

TEST(ClusterTree, is_quick_for_many_items) {
    const auto boxes = random_boxes(100000, 0.001F, 0.5F);
    const auto start = std::chrono::steady_clock::now();
    const ClusterTree tree = build(boxes, 8);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    EXPECT_LT(spent.count(), 3);  // 0.1 s on one idle core
    EXPECT_GT(tree.nodes.size(), 100000U / 8);
    expect_well_formed(tree, boxes);
}

}  // namespace
}  // namespace gg
