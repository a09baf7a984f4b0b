// Where sunlight ends.
#include "radiosity/shadow_edges.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/opened_clusters.h"

namespace gg::test {
namespace {

// A closed room of 4 x 4 x 2.5 m whose ceiling has a hole of 20 cm for the sun.
SceneDescription room_with_a_hole() {
    SceneBuilder builder;
    const auto grey = builder.material(Rgb(0.5F));
    builder.quad({-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}, grey, "floor");
    builder.quad({-2, -2, 0}, {-2, -2, 2.5F}, {-2, 2, 2.5F}, {-2, 2, 0}, grey, "wall");
    builder.quad({2, -2, 0}, {2, 2, 0}, {2, 2, 2.5F}, {2, -2, 2.5F}, grey, "wall");
    builder.quad({-2, -2, 0}, {2, -2, 0}, {2, -2, 2.5F}, {-2, -2, 2.5F}, grey, "wall");
    builder.quad({-2, 2, 0}, {-2, 2, 2.5F}, {2, 2, 2.5F}, {2, 2, 0}, grey, "wall");
    constexpr float a = 0.9F, b = 1.1F;
    builder.quad({-2, -2, 2.5F}, {-2, 2, 2.5F}, {a, 2, 2.5F}, {a, -2, 2.5F}, grey, "ceiling");
    builder.quad({b, -2, 2.5F}, {b, 2, 2.5F}, {2, 2, 2.5F}, {2, -2, 2.5F}, grey, "ceiling");
    builder.quad({a, -2, 2.5F}, {a, a, 2.5F}, {b, a, 2.5F}, {b, -2, 2.5F}, grey, "ceiling");
    builder.quad({a, b, 2.5F}, {a, 2, 2.5F}, {b, 2, 2.5F}, {b, b, 2.5F}, grey, "ceiling");
    builder.sun({0, 0, -1}, Rgb(100));
    return builder.description;
}

// The patch is a four-hundredth of the floor.
TEST(ShadowEdges, a_small_patch_of_sunlight_is_found) {
    Prepared prepared(room_with_a_hole());
    Hierarchy hierarchy(prepared.scene, *prepared.colors, prepared.faces());
    open_clusters(hierarchy, prepared.control);
    Lighting lighting(hierarchy);
    lighting.grow(prepared.control);
    const SourceGuide guide(hierarchy, initial_links(hierarchy).all);
    split_at_shadow_edges(hierarchy, lighting, guide, *prepared.tracer, {0.01F, {10, 4}}, prepared.control);
    float smallest = 9, at_patch = 9;
    for (const Node& node : hierarchy.nodes()) {
        if (node.kind == NodeKind::kElement && node.child_count == 0 && node.instance == 0 && !node.back) {
            smallest = std::min(smallest, 2 * node.radius);
            if (length(node.center - Vec3(0.9F, 1, 0)) < 0.15F) {
                at_patch = std::min(at_patch, 2 * node.radius);
            }
        }
    }
    EXPECT_LT(at_patch, 0.2F);
    EXPECT_EQ(at_patch, smallest);
    int far = 0;
    for (const Node& node : hierarchy.nodes()) {
        far += node.kind == NodeKind::kElement && node.child_count == 0 && node.instance == 0 && !node.back &&
               length(node.center - Vec3(1, 1, 0)) > 1.5F;
    }
    EXPECT_LT(far, 12);
}

TEST(ShadowEdges, even_light_divides_nothing) {
    SceneBuilder builder;
    builder.quad({-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}, builder.material(Rgb(0.5F)), "floor");
    builder.sun({0, 0, -1}, Rgb(100));
    Prepared prepared(builder.description);
    Hierarchy hierarchy(prepared.scene, *prepared.colors, prepared.faces());
    Lighting lighting(hierarchy);
    open_clusters(hierarchy, prepared.control);
    lighting.grow(prepared.control);
    const std::size_t before = hierarchy.nodes().size();
    ASSERT_GT(before, 3U);
    const SourceGuide guide(hierarchy, initial_links(hierarchy).all);
    split_at_shadow_edges(hierarchy, lighting, guide, *prepared.tracer, {0.01F, {1, 4}}, prepared.control);
    EXPECT_EQ(hierarchy.nodes().size(), before);
}

}  // namespace
}  // namespace gg::test
