// Above and below the horizon, near and at infinity.
#include "gather/sender_place.h"

#include <gtest/gtest.h>

namespace gg {
namespace {

Node sender(NodeKind kind, Vec3 center, float radius) {
    Node node;
    node.kind = kind;
    node.center = center;
    node.radius = radius;
    return node;
}

TEST(SenderPlace, an_element_is_below_across_or_above_by_its_radius) {
    const Scene scene;
    const Vec3 x(0, 0, 10), n(0, 0, 1);
    EXPECT_TRUE(is_below_horizon(scene, sender(NodeKind::kElement, {3, 0, 8.9F}, 1), x, n));
    EXPECT_FALSE(is_below_horizon(scene, sender(NodeKind::kElement, {3, 0, 9.1F}, 1), x, n));
    EXPECT_TRUE(crosses_horizon(scene, sender(NodeKind::kElement, {3, 0, 10.9F}, 1), x, n));
    EXPECT_FALSE(crosses_horizon(scene, sender(NodeKind::kElement, {3, 0, 11.1F}, 1), x, n));
}

// Its middle is a direction: where the receiver stands makes no difference, however far from the world's origin.
TEST(SenderPlace, the_sun_is_a_direction) {
    Scene scene;
    scene.lamps.resize(1);
    scene.lamps[0].shape = LampShape::kDistant;
    scene.lamps[0].cos_half_angle = std::cos(0.01F);
    const Node sun = sender(NodeKind::kLamp, {0, 0, 1}, 0);
    for (const Vec3 x : {Vec3(0.0F), Vec3(0, 0, 50), Vec3(0, 0, -50)}) {
        EXPECT_FALSE(is_below_horizon(scene, sun, x, {0, 0, 1}));
        EXPECT_TRUE(is_below_horizon(scene, sun, x, {0, 0, -1}));
        EXPECT_FALSE(crosses_horizon(scene, sun, x, {0, 0, 1}));
        EXPECT_TRUE(crosses_horizon(scene, sun, x, {1, 0, 0.005F}));
        EXPECT_FALSE(is_close(scene, sun, {x, x}));
    }
}

TEST(SenderPlace, close_is_twice_both_sizes) {
    const Scene scene;
    const Box box{{-0.5F, 0, 0}, {0.5F, 0, 0}};
    EXPECT_TRUE(is_close(scene, sender(NodeKind::kCluster, {2.9F, 0, 0}, 1), box));
    EXPECT_FALSE(is_close(scene, sender(NodeKind::kCluster, {3.1F, 0, 0}, 1), box));
}

}  // namespace
}  // namespace gg
