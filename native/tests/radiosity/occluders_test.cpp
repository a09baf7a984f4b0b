// Links know how far off what blocks them is.
#include <gtest/gtest.h>

#include "radiosity/solution.h"
#include "support/test_scenes.h"

namespace gg::test {
namespace {

// A floor under two boards, at 1 and 2 m.
SceneBuilder boards_over_a_floor() {
    SceneBuilder scene;
    const std::uint32_t grey = scene.material(Rgb(0.5F));
    scene.quad({-3, -3, 0}, {3, -3, 0}, {3, 3, 0}, {-3, 3, 0}, grey, "floor");
    scene.quad({-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}, grey, "lower");
    scene.quad({-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}, grey, "upper");
    return scene;
}

struct Occluders {
    float nearest = kInfinity, farthest = 0;  // of all partly blocked links from lamps to the floor
    int links = 0;
};

Occluders occluders_of(const SceneDescription& description) {
    Prepared prepared(description);
    const auto solution = prepared.solve();
    const Hierarchy& hierarchy = hierarchy_of(*solution);
    Occluders found;
    for (NodeId id = 0; id < hierarchy.nodes().size(); ++id) {
        if (hierarchy[id].kind != NodeKind::kElement || hierarchy[id].instance != 0) {
            continue;
        }
        for (const Link& link : links_to(*solution, id)) {
            if (hierarchy[link.sender].kind == NodeKind::kLamp && link.farthest_occluder > 0) {
                EXPECT_LE(link.nearest_occluder, 1.0001F * link.farthest_occluder);
                found.nearest = std::min(found.nearest, link.nearest_occluder);
                found.farthest = std::max(found.farthest, link.farthest_occluder);
                ++found.links;
            }
        }
    }
    return found;
}

TEST(occluders, of_the_sun_are_as_far_as_they_stand) {
    SceneBuilder scene = boards_over_a_floor();
    scene.sun({0, 0, -1}, Rgb(3.0F));
    const Occluders found = occluders_of(scene.description);
    ASSERT_GT(found.links, 3);
    EXPECT_NEAR(found.nearest, 1, 0.01F);
    EXPECT_NEAR(found.farthest, 2, 0.01F);
}

TEST(occluders, of_a_lamp_are_as_far_as_its_rays_are_long) {
    SceneBuilder scene = boards_over_a_floor();
    scene.area_light({0, 0, 4}, {0, 0, -1}, 0.5F, Rgb(100.0F));
    const Occluders found = occluders_of(scene.description);
    ASSERT_GT(found.links, 3);
    const float slant = std::sqrt(1 + 2 * 1.25F * 1.25F / 4);  // of a ray from the lamp's corner to the board's
    EXPECT_GE(found.nearest, 0.99F);
    EXPECT_GE(found.farthest, 1.99F);
    EXPECT_LE(found.farthest, 2.01F * slant);
}

}  // namespace
}  // namespace gg::test
