// A large element that is bright at one end sends more to what stands there.
#include <gtest/gtest.h>

#include "radiosity/link_estimate.h"
#include "support/law_scenes.h"

namespace gg::test {
namespace {

// A floor of 3 x 1 m with a small wall at each end, and a lamp over the end at x = 0.
struct Corridor {
    Corridor() {
        SceneBuilder builder;
        const std::uint32_t grey = builder.material(Rgb(0.5F));
        builder.quad({0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0}, grey, "floor");
        builder.quad({0, 0, 0.1F}, {0, 1, 0.1F}, {0, 1, 1}, {0, 0, 1}, grey, "lit end");
        builder.quad({3, 0, 0.1F}, {3, 0, 1}, {3, 1, 1}, {3, 1, 0.1F}, grey, "dark end");
        builder.area_light({0.7F, 0.5F, 1.3F}, {0, 0, -1}, 0.5F, Rgb(100));
        prepared = std::make_unique<Prepared>(builder.description);
        solution = prepared->solve(0.01F);
    }

    // The first triangle of an instance, its front.
    [[nodiscard]] NodeId root(std::uint32_t instance, std::uint32_t triangle) const {
        const auto& nodes = solution->hierarchy.nodes();
        for (NodeId id = 0; id < nodes.size(); ++id) {
            if (nodes[id].kind == NodeKind::kElement && nodes[id].depth == 0 && nodes[id].instance == instance &&
                nodes[id].source == triangle && !nodes[id].back) {
                return id;
            }
        }
        return kNone;
    }

    [[nodiscard]] Link link(std::uint32_t receiver, bool uneven) const {
        return estimate_link(solution->hierarchy, *prepared->tracer, root(receiver, 0), root(0, 0), 64,
                             SampleSet::kLink, nullptr, uneven ? &solution->lighting : nullptr);
    }

    std::unique_ptr<Prepared> prepared;
    std::shared_ptr<const Solution> solution;
};

TEST(Brightness, of_a_floor_that_is_lit_at_one_end) {
    const Corridor corridor;
    const Link lit = corridor.link(1, true), dark = corridor.link(2, true);
    ASSERT_GT(lit.form_factor, 0.01F);
    ASSERT_GT(dark.form_factor, 0.01F);
    EXPECT_GT(lit.brightness, 1.5F);
    EXPECT_LT(dark.brightness, 0.7F);
    EXPECT_EQ(corridor.link(1, false).brightness, 1);
}

// Irradiance at the lit end, by every leaf of the floor on its own.
TEST(Brightness, times_the_mean_is_what_the_leaves_send) {
    const Corridor corridor;
    const auto& nodes = corridor.solution->hierarchy.nodes();
    const NodeId receiver = corridor.root(1, 0), floor = corridor.root(0, 0);
    double leaves = 0;
    for (NodeId id = 0; id < nodes.size(); ++id) {
        if (nodes[id].kind == NodeKind::kElement && nodes[id].instance == 0 && nodes[id].source == 0 &&
            !nodes[id].back && nodes[id].child_count == 0) {
            const Link link = corridor.prepared->estimate(corridor.solution->hierarchy, receiver, id, 64);
            leaves += link.form_factor * link.visibility * luminance(corridor.solution->lighting.radiosity(id));
        }
    }
    const Link whole = corridor.link(1, true);
    const double at_once = whole.form_factor * whole.visibility * whole.brightness *
                           luminance(corridor.solution->lighting.radiosity(floor));
    EXPECT_NEAR(at_once / leaves, 1, 0.2);
}

// All the light of a small plate close above a large floor lands on it, though none of the floor's few points is near.
TEST(SmallSender, sends_all_it_has_to_the_floor_below_it) {
    SceneBuilder builder;
    const std::uint32_t grey = builder.material(Rgb(0.5F));
    builder.quad({0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}, grey, "floor");
    builder.quad({6, 1, 0.02F}, {6, 1.2F, 0.02F}, {6.2F, 1.2F, 0.02F}, {6.2F, 1, 0.02F}, grey, "plate");
    builder.area_light({4, 4, 3}, {0, 0, -1}, 1, Rgb(100));
    Prepared prepared(builder.description);
    const auto solution = prepared.solve(0.05F);
    const auto& nodes = solution->hierarchy.nodes();
    double received = 0, sent = 0;
    for (NodeId sender = 0; sender < nodes.size(); ++sender) {
        if (nodes[sender].kind != NodeKind::kElement || nodes[sender].depth > 0 || nodes[sender].instance != 1 ||
            nodes[sender].normal.z > 0) {
            continue;
        }
        sent += nodes[sender].area;
        for (NodeId floor = 0; floor < nodes.size(); ++floor) {
            if (nodes[floor].kind == NodeKind::kElement && nodes[floor].depth == 0 && nodes[floor].instance == 0 &&
                !nodes[floor].back) {
                received += nodes[floor].area * prepared.estimate(solution->hierarchy, floor, sender, 64).form_factor;
            }
        }
    }
    ASSERT_NEAR(sent, 0.04, 1e-6);
    EXPECT_NEAR(received / sent, 1, 0.02);
}

}  // namespace
}  // namespace gg::test
