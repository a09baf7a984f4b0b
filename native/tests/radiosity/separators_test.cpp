// What stands on an element and keeps light from a part of it.
#include "radiosity/separators.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/opened_clusters.h"

namespace gg::test {
namespace {

// A floor of 4 x 4 m below an even sky, with a wall across it at x = 0.3, 2 m high; a roof over x > 0.3, or none, and a
// wall at each of its other sides.
SceneDescription walled_floor(bool roofed) {
    SceneBuilder builder;
    const auto grey = builder.material(Rgb(0.5F));
    builder.quad({-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}, grey, "floor");
    builder.solid({0.3F, -2, -0.01F}, {0.32F, 2, 2}, grey, "wall");
    if (roofed) {
        builder.solid({0.3F, -2.1F, 2}, {2.1F, 2.1F, 2.02F}, grey, "roof");
        builder.solid({0.3F, -2.1F, -0.1F}, {2.1F, -2, 2.02F}, grey, "side");
        builder.solid({0.3F, 2, -0.1F}, {2.1F, 2.1F, 2.02F}, grey, "side");
        builder.solid({2, -2.1F, -0.1F}, {2.1F, 2.1F, 2.02F}, grey, "end");
    }
    builder.description.world = Rgb(1.0F);
    return builder.description;
}

struct Split : OpenedClusters {
    explicit Split(const SceneDescription& description, float tolerance = 0.02F) : OpenedClusters(description) {
        split_at_separators(hierarchy, lighting, *prepared.tracer, {tolerance, {3, 3}}, prepared.control);
    }

    // Largest leaf element of the floor's upper side that crosses a line along y.
    float largest_across(float x) {
        float largest = 0;
        for (const Node& node : hierarchy.nodes()) {
            if (node.kind == NodeKind::kElement && node.child_count == 0 && node.instance == 0 && !node.back) {
                const auto [least, most] = std::minmax({node.corner[0].x, node.corner[1].x, node.corner[2].x});
                largest = least < x && x < most ? std::max(largest, 2 * node.radius) : largest;
            }
        }
        return largest;
    }
};

TEST(Separators, a_floor_is_divided_below_the_wall_of_a_dark_room) {
    Split split(walled_floor(true));
    EXPECT_LT(split.largest_across(0.31F), 0.2F);
    EXPECT_GT(split.largest_across(-1.2F), 0.5F);
    EXPECT_GT(split.largest_across(1.2F), 0.5F);
}

TEST(Separators, nothing_is_divided_where_nothing_stands) {
    SceneBuilder builder;
    const auto grey = builder.material(Rgb(0.5F));
    builder.quad({-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}, grey, "floor");
    builder.solid({-2, -2, 2}, {0, 2, 2.1F}, grey, "shade");
    builder.description.world = Rgb(1.0F);
    const Split split(builder.description);
    EXPECT_EQ(split.hierarchy.nodes().size(), split.before);
}

TEST(Separators, a_difference_within_the_tolerance_divides_nothing) {
    const Split split(walled_floor(true), 2);
    EXPECT_EQ(split.hierarchy.nodes().size(), split.before);
}

// Both sides of the wall see the same sky.
TEST(Separators, a_wall_below_an_even_sky_divides_less_than_one_of_a_dark_room) {
    const Split open(walled_floor(false), 0.5F), dark(walled_floor(true), 0.5F);
    EXPECT_LT(open.hierarchy.nodes().size() - open.before, (dark.hierarchy.nodes().size() - dark.before) / 4);
}

}  // namespace
}  // namespace gg::test
