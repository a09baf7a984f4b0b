// What a ray sees of the light that is known.
#include "radiosity/seen_light.h"

#include <gtest/gtest.h>

#include "support/test_scenes.h"

namespace gg::test {
namespace {

TEST(SeenLight, elements_clusters_and_the_world_have_their_radiosity) {
    SceneBuilder builder;
    builder.quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, builder.material(Rgb(0.5F), Rgb(2.0F)), "plate");
    builder.sphere({5, 0, 0}, 1, 8, builder.material(Rgb(0.5F), Rgb(1.0F)), false, "ball");
    builder.description.world = Rgb(3.0F);
    Prepared prepared(builder.description);
    Hierarchy hierarchy(prepared.scene, *prepared.colors, prepared.faces());
    // The plate becomes elements; the ball stays a cluster.
    for (NodeId id = 0; id < hierarchy.nodes().size(); ++id) {
        if (is_cluster(hierarchy[id]) && hierarchy[id].instance != 1) {
            hierarchy.open(std::vector<NodeId>{id}, prepared.control);
        }
    }
    Lighting lighting(hierarchy);
    lighting.grow(prepared.control);
    const SeenLight seen(hierarchy, lighting);
    const auto radiosity = [&](Vec3 origin, Vec3 direction) {
        const Ray ray{origin, direction, 0, kInfinity};
        return seen.radiosity(ray, prepared.tracer->closest_hit(ray, RayMask::kLight)).x;
    };
    EXPECT_NEAR(radiosity({0.3F, 0.2F, 1}, {0, 0, -1}), 2 * kPi, 1e-4F);
    EXPECT_NEAR(radiosity({5, 0, 3}, {0.01F, 0.02F, -1}), kPi, 1e-4F);
    EXPECT_NEAR(radiosity({0, 0, 1}, {0, 0, 1}), 3 * kPi, 1e-4F);
}

}  // namespace
}  // namespace gg::test
