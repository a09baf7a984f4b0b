// Groups partition the sides of a mesh that light reaches, and what is in one lies alike.
#include "radiosity/face_groups.h"

#include <gtest/gtest.h>

#include "support/clouds.h"
#include "support/law_scenes.h"
#include "support/meshes.h"

namespace gg::test {
namespace {

void expect_partition(const Prepared& prepared) {
    const SceneFaces faces = prepared.faces();
    const FaceGroups& groups = faces.meshes[0].groups;
    const auto count = static_cast<std::uint32_t>(prepared.scene.meshes[0].triangles.size());
    ASSERT_EQ(groups.of_front.size(), count);
    std::size_t sides = 0;
    for (std::uint32_t group = 0; group < groups.count(); ++group) {
        ASSERT_FALSE(groups[group].empty());
        for (const FaceSide side : groups[group]) {
            EXPECT_EQ(groups.of(side.triangle, side.back), group);
            EXPECT_TRUE(has_side(prepared.scene.sides_of(0, side.triangle), side.back));
            ++sides;
        }
    }
    std::size_t lit = 0;
    for (std::uint32_t triangle = 0; triangle < count; ++triangle) {
        for (const bool back : {false, true}) {
            lit += has_side(prepared.scene.sides_of(0, triangle), back) ? 1 : 0;
        }
    }
    EXPECT_EQ(sides, lit);
}

TEST(FaceGroups, partition_the_sides_of_leaves_and_of_solids) {
    for (const bool solid : {false, true}) {
        SceneBuilder builder;
        const Box box{{0, 0, 0}, {1, 1, 1}};
        builder.add_mesh(solid ? cube_cloud(box, 60, 0.1F, 3) : triangle_cloud(box, 500, 0.1F, 3),
                         builder.material(Rgb(0.5F)));
        expect_partition(Prepared(builder.description));
    }
}

TEST(FaceGroups, are_few_on_a_fine_sphere_and_face_one_way) {
    SceneBuilder builder;
    builder.sphere({0, 0, 0}, 1, 64, builder.material(Rgb(0.5F)), false);
    const Prepared prepared(builder.description);
    const SceneFaces faces = prepared.faces();
    const FaceGroups& groups = faces.meshes[0].groups;
    EXPECT_LT(groups.count(), prepared.scene.meshes[0].triangles.size() / 4);
    for (std::uint32_t group = 0; group < groups.count(); ++group) {
        const auto normal_of = [&](FaceSide side) {
            const Vec3 front = normalize(world_area_vector(prepared.scene, 0, side.triangle));
            return side.back ? -front : front;
        };
        for (const FaceSide side : groups[group]) {
            EXPECT_GT(dot(normal_of(side), normal_of(groups[group].front())), 0.75F);
        }
    }
}

}  // namespace
}  // namespace gg::test
