// Cuts: disjoint, and every part of a linked sender once.
#include "gather/sender_cut.h"

#include <gtest/gtest.h>

#include <set>

#include "core/random.h"
#include "support/law_scenes.h"

namespace gg::test {
namespace {

// Leaves of the hierarchy below a node.
void add_leaves(const Hierarchy& hierarchy, NodeId id, std::vector<NodeId>& out) {
    const Node& node = hierarchy[id];
    if (node.child_count == 0) {
        out.push_back(id);
    }
    for (NodeId child = node.first_child; child < node.first_child + node.child_count; ++child) {
        add_leaves(hierarchy, child, out);
    }
}

std::vector<NodeId> surface_leaves_of(const Hierarchy& hierarchy) {
    std::vector<NodeId> leaves;
    for (NodeId id = 0; id < hierarchy.nodes().size(); ++id) {
        if (is_surface(hierarchy[id]) && hierarchy[id].child_count == 0) {
            leaves.push_back(id);
        }
    }
    return leaves;
}

class SenderCutTest : public testing::TestWithParam<int> {};

// With receivers from anywhere: what the links of all of them and their ancestors reach.
TEST_P(SenderCutTest, covers_every_linked_leaf_once) {
    Prepared prepared(mixed_scene());
    const auto solution = prepared.solve(0.05F);
    const Hierarchy& hierarchy = hierarchy_of(*solution);
    const std::vector<NodeId> leaves = surface_leaves_of(hierarchy);
    CutBuilder builder(*solution);
    SenderCut cut;
    for (std::uint64_t round = 0; round < 40; ++round) {
        std::vector<NodeId> receivers;
        for (int k = 0; k < GetParam(); ++k) {
            receivers.push_back(leaves[hash64(round, k) % leaves.size()]);
        }
        Box bounds;
        std::set<NodeId> linked;
        for (const NodeId receiver : receivers) {
            bounds.extend(hierarchy[receiver].center);
            for (NodeId id = receiver; id != kNone; id = hierarchy[id].parent) {
                for (const Link& link : links_to(*solution, id)) {
                    std::vector<NodeId> below;
                    add_leaves(hierarchy, link.sender, below);
                    linked.insert(below.begin(), below.end());
                }
            }
        }
        builder.build({receivers, bounds, 1.0F}, cut);
        std::vector<NodeId> covered;
        for (const CutSender& sender : cut.senders) {
            EXPECT_GE(sender.visibility, 0);
            EXPECT_LE(sender.visibility, 1);
            add_leaves(hierarchy, sender.sender, covered);
        }
        for (const NodeId near : cut.near) {
            EXPECT_TRUE(is_cluster(hierarchy[near]));
            add_leaves(hierarchy, near, covered);
        }
        EXPECT_EQ(covered.size(), std::set<NodeId>(covered.begin(), covered.end()).size());
        EXPECT_EQ(std::set<NodeId>(covered.begin(), covered.end()), linked);
    }
}

INSTANTIATE_TEST_SUITE_P(receivers, SenderCutTest, testing::Values(1, 3, 12));

TEST(SenderCutTest, uneven_senders_are_opened_where_little_light_is_expected) {
    Prepared prepared(lamp_room(0.5F));
    const auto solution = prepared.solve();
    const Hierarchy& hierarchy = hierarchy_of(*solution);
    NodeId receiver = kNone;  // in the middle of the floor
    for (const NodeId leaf : surface_leaves_of(hierarchy)) {
        if (hierarchy[leaf].instance == 4 && !hierarchy[leaf].back &&
            (receiver == kNone || length(hierarchy[leaf].center) < length(hierarchy[receiver].center))) {
            receiver = leaf;
        }
    }
    Box bounds;
    bounds.extend(hierarchy[receiver].center);
    CutBuilder builder(*solution);
    SenderCut rough, fine;
    builder.build({std::span(&receiver, 1), bounds, 1000.0F}, rough);
    builder.build({std::span(&receiver, 1), bounds, 1e-3F}, fine);
    EXPECT_GT(fine.senders.size(), rough.senders.size() + 10);
}

}  // namespace
}  // namespace gg::test
