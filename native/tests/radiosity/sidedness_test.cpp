// Light stays on the side of a sheet or a solid that it falls on.
#include <gtest/gtest.h>

#include "support/clouds.h"
#include "support/law_scenes.h"
#include "support/solution_measures.h"

namespace gg::test {
namespace {

FaceMeans side_of(const Solution& solution, std::uint32_t instance, bool back) {
    return means_of(solution, [&](const Node& node) {
        return node.instance == instance && node.kind == NodeKind::kElement && node.back == back;
    });
}

TEST(Sidedness, sheet_below_a_lamp_is_dark_below) {
    SceneBuilder builder;
    const std::uint32_t grey = builder.material(Rgb(0.5F));
    builder.quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, grey);
    builder.area_light({0.5F, 0.5F, 1}, {0, 0, -1}, 0.5F, Rgb(100));
    Prepared prepared(builder.description);
    const auto solution = prepared.solve();
    EXPECT_GT(luminance_of(side_of(*solution, 0, false).irradiance), 10);
    EXPECT_EQ(luminance_of(side_of(*solution, 0, true).irradiance), 0);
    EXPECT_GT(luminance(interpolated_irradiance(*solution, 0, 0, false, {0.3F, 0.3F})), 10);
    EXPECT_EQ(interpolated_irradiance(*solution, 0, 0, true, {0.3F, 0.3F}), Rgb(0.0F));
}

// In a mesh of its own that is not opened: the cluster's directional light tells the sides apart.
TEST(Sidedness, small_sheet_below_a_lamp_is_dark_below) {
    SceneBuilder builder;
    const std::uint32_t grey = builder.material(Rgb(0.5F));
    builder.box(Vec3(0.0F), kRoomSize, {grey, grey, grey, grey, grey, grey}, true);
    builder.quad({2, 1.5F, 1}, {2.02F, 1.5F, 1}, {2.02F, 1.52F, 1}, {2, 1.52F, 1}, grey, "leaf");
    builder.description.materials[grey].reflectance.factor = Rgb(0.0F);
    builder.area_light({2, 1.5F, 2}, {0, 0, -1}, 0.05F, Rgb(100));
    Prepared prepared(builder.description);
    const auto solution = prepared.solve();
    const float above = luminance(interpolated_irradiance(*solution, 6, 0, false, {0.3F, 0.3F}));
    const float below = luminance(interpolated_irradiance(*solution, 6, 0, true, {0.3F, 0.3F}));
    EXPECT_GT(above, 10);
    EXPECT_LT(below, 0.1F * above);
}

// Walls of two sides, so that the inside is computed at all, and a cloud inside that would gather any leak.
TEST(Sidedness, closed_box_that_is_lit_from_outside_is_dark_inside) {
    SceneBuilder builder;
    const std::uint32_t grey = builder.material(Rgb(0.7F));
    builder.box(Vec3(0.0F), Vec3(1.0F), {grey, grey, grey, grey, grey, grey}, true);
    builder.add_mesh(triangle_cloud({Vec3(0.2F), Vec3(0.8F)}, 500, 0.08F, 1), grey);
    builder.quad({-3, -3, -0.5F}, {4, -3, -0.5F}, {4, 4, -0.5F}, {-3, 4, -0.5F}, grey, "ground");
    builder.area_light({3, 2, 3}, {-1, -0.7F, -1}, 1, Rgb(500));
    builder.sun({0.5F, 0.4F, -1}, Rgb(20));
    builder.description.world = Rgb(1.0F);
    Prepared prepared(builder.description);
    const auto solution = prepared.solve();
    double outside = 0;
    for (std::uint32_t wall = 0; wall < 6; ++wall) {
        outside += luminance_of(side_of(*solution, wall, true).irradiance) / 6;
    }
    EXPECT_GT(outside, 5);
    for (std::uint32_t wall = 0; wall < 6; ++wall) {
        EXPECT_LT(side_of(*solution, wall, false).most, 1e-4 * outside) << "wall " << wall;
    }
    EXPECT_LT(means_of_instance(*solution, 6).most, 1e-4 * outside);
}

}  // namespace
}  // namespace gg::test
