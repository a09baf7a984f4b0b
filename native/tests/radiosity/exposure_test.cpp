// Which faces of an object get light from outside.
#include "radiosity/exposure.h"

#include <gtest/gtest.h>

#include "radiosity/leaf_cluster.h"
#include "support/clouds.h"
#include "support/law_scenes.h"
#include "support/meshes.h"

namespace gg::test {
namespace {

// A small box in a large one, one mesh.
struct Boxes {
    Boxes() {
        SceneBuilder builder;
        const std::uint32_t grey = builder.material(Rgb(0.5F));
        builder.add_mesh(split(join(make_box(Vec3(0), Vec3(1)), make_box(Vec3(0.3F), Vec3(0.7F)))), grey);
        builder.area_light({0.5F, 0.5F, 3}, {0, 0, -1}, 1, Rgb(100));
        prepared = std::make_unique<Prepared>(builder.description);
    }
    std::unique_ptr<Prepared> prepared;
};

TEST(Exposure, outer_faces_have_it_and_inner_ones_do_not) {
    const Boxes boxes;
    const SceneFaces faces = boxes.prepared->faces();
    const auto& exposure = faces.meshes[0].exposure;
    ASSERT_EQ(exposure.size(), 24U);
    for (std::size_t triangle = 0; triangle < 12; ++triangle) {
        const Exposure& outer = exposure[triangle];
        EXPECT_EQ(outer.front, 1) << triangle;
        EXPECT_LT(outer.front_shelter, 0.05F) << triangle;
        const Exposure& inner = exposure[12 + triangle];
        EXPECT_LT(inner.front + inner.back, 0.05F) << triangle;
    }
}

// Whatever the exposure of faces, all the power that falls on a cluster is shared out, and none more.
TEST(Exposure, sharing_out_keeps_power) {
    SceneBuilder builder;
    const std::uint32_t grey = builder.material(Rgb(1.0F));
    builder.add_mesh(triangle_cloud({Vec3(0), Vec3(1)}, 400, 0.2F, 3), grey);
    builder.area_light({0.5F, 0.5F, 3}, {0, 0, -1}, 1, Rgb(100));
    Prepared prepared(builder.description);
    Hierarchy hierarchy(prepared.scene, *prepared.colors, prepared.faces());
    const Node& root = hierarchy[kGeometryRoot];
    const FacingArea facing = facing_area(hierarchy, root);
    const LeafCluster leaf = make_leaf_cluster(hierarchy, root);
    for (const Vec3 direction : {Vec3(1, 0, 0), Vec3(0, -1, 0), normalize_or_zero({1, 2, -3})}) {
        DirectionalForm light;
        add_beam(light, Rgb(2), direction);
        double alike = 0, shared = 0;
        const float factor = share_out_far(facing, light);
        for (std::size_t i = 0; i < kFormSize; ++i) {
            alike += facing.area[i] * light.coefficients[i].r;
            shared += facing.exposed[i] * factor * light.coefficients[i].r;
        }
        EXPECT_NEAR(shared / alike, 1, 1e-4);
        EXPECT_GE(factor, 1);
    }
    // A beam on faces of all directions: a quarter of their area faces it.
    double area = 0;
    for (std::size_t i = 0; i < kFormSize; ++i) {
        area += facing.area[i] * beam_coefficients({0, 0, 1})[i];
    }
    EXPECT_NEAR(area / leaf.area, 0.25, 0.03);
}

}  // namespace
}  // namespace gg::test
