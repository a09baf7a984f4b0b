// Large faces become elements, small ones stay in clusters.
#include "radiosity/large_faces.h"

#include <gtest/gtest.h>

#include "support/test_scenes.h"

namespace gg::test {
namespace {

TEST(LargeFaces, leave_clusters_and_small_ones_do_not) {
    SceneBuilder builder;
    const auto grey = builder.material(Rgb(0.5F));
    builder.sphere({0, 0, 1}, 0.2F, 24, grey, false);
    builder.quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, grey, "floor");
    Prepared prepared(builder.description);
    Hierarchy hierarchy(prepared.scene, *prepared.colors, prepared.faces());
    Lighting lighting(hierarchy);
    lighting.grow(prepared.control);
    open_large_faces(hierarchy, lighting, 0.5F, prepared.control);
    int elements = 0;
    std::size_t in_clusters = 0;
    for (const Node& node : hierarchy.nodes()) {
        if (node.child_count > 0) {
            continue;
        }
        if (node.kind == NodeKind::kElement) {
            EXPECT_EQ(node.instance, 1U);
            ++elements;
        } else if (is_cluster(node)) {
            in_clusters += hierarchy.triangle_count(node);
        }
    }
    EXPECT_EQ(elements, 4);  // both sides of the floor's triangles
    EXPECT_EQ(in_clusters, prepared.scene.meshes[0].triangles.size());
}

TEST(LargeFaces, an_empty_scene_has_none) {
    Prepared prepared(SceneDescription{});
    Hierarchy hierarchy(prepared.scene, *prepared.colors, prepared.faces());
    Lighting lighting(hierarchy);
    lighting.grow(prepared.control);
    const std::size_t before = hierarchy.nodes().size();
    open_large_faces(hierarchy, lighting, 0.5F, prepared.control);
    EXPECT_EQ(hierarchy.nodes().size(), before);
}

}  // namespace
}  // namespace gg::test
