// Neighbouring elements differ by one level of division at most.
#include "radiosity/mesh_balance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

#include "support/test_scenes.h"

namespace gg::test {
namespace {

using Key = std::tuple<long, long, long>;

Key key_of(Vec3 p) {
    const auto round = [](float x) { return std::lround(1e4F * x); };
    return {round(p.x), round(p.y), round(p.z)};
}

// Leaf elements that have a corner of another one within a quarter of one of their edges.
int coarse_leaves(const Hierarchy& hierarchy) {
    std::set<Key> corners;
    for (const Node& node : hierarchy.nodes()) {
        if (node.kind == NodeKind::kElement && node.child_count == 0) {
            for (const Vec3 c : node.corner) {
                corners.insert(key_of(c));
            }
        }
    }
    int count = 0;
    for (const Node& node : hierarchy.nodes()) {
        if (node.kind != NodeKind::kElement || node.child_count > 0) {
            continue;
        }
        bool coarse = false;
        for (int k = 0; k < 3; ++k) {
            const Vec3 a = node.corner[k], b = node.corner[(k + 1) % 3];
            coarse = coarse || corners.contains(key_of(0.75F * a + 0.25F * b)) ||
                     corners.contains(key_of(0.25F * a + 0.75F * b));
        }
        count += coarse;
    }
    return count;
}

TEST(MeshBalance, grades_elements_around_a_small_one) {
    SceneBuilder builder;
    builder.quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, builder.material(Rgb(0.5F)));
    Prepared prepared(builder.description);
    Hierarchy hierarchy(prepared.scene, *prepared.colors, prepared.faces());
    Lighting lighting(hierarchy);
    // Down to one small element in the middle of the diagonal, where both triangles meet.
    for (int round = 0; round < 10; ++round) {
        std::vector<NodeId> leaves;
        for (NodeId id = 0; id < hierarchy.nodes().size(); ++id) {
            const Node& node = hierarchy[id];
            const bool small =
                node.kind == NodeKind::kElement &&
                (node.source > 0 || node.depth > 5 || length(node.center - Vec3(0.55F, 0.45F, 0)) > node.radius);
            if (is_surface(node) && node.child_count == 0 && !small) {
                leaves.push_back(id);
            }
        }
        hierarchy.open(leaves, prepared.control);
    }
    lighting.grow(prepared.control);
    const std::size_t before = hierarchy.nodes().size();
    ASSERT_GT(coarse_leaves(hierarchy), 0);
    balance_elements(hierarchy, lighting, prepared.control);
    EXPECT_EQ(coarse_leaves(hierarchy), 0);
    EXPECT_LT(hierarchy.nodes().size(), before + 400);  // a hundred elements, not the whole quad
}

}  // namespace
}  // namespace gg::test
