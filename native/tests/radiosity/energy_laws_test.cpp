// Laws of whole solutions: furnace, energy balance, integrating sphere.
#include <gtest/gtest.h>

#include <cmath>

#include "support/test_scenes.h"

namespace gg::test {
namespace {

struct Extremes {
    double least = 1e30, most = 0, mean = 0, area = 0;
};

// Luminance of the radiosity of the leaves that `of` picks, W/m2.
template <typename Pick>
Extremes leaf_radiosity(const Solution& solution, const Pick& pick) {
    Extremes result;
    for (NodeId id = 0; id < solution.hierarchy.nodes().size(); ++id) {
        const Node& node = solution.hierarchy[id];
        if (!is_surface(node) || node.child_count > 0 || !pick(node)) {
            continue;
        }
        const double b = luminance(solution.lighting.radiosity(id));
        const double area = solution.lighting.area(id);
        result.least = std::min(result.least, b);
        result.most = std::max(result.most, b);
        result.mean += b * area;
        result.area += area;
    }
    result.mean /= result.area;
    return result;
}

bool front(const Node& node) { return node.kind != NodeKind::kElement || !node.back; }

SceneDescription furnace(float reflectance, bool furnished) {
    SceneBuilder builder;
    const float radiance = 1 / kPi;  // radiosity 1
    const std::uint32_t m = builder.material(Rgb(reflectance), Rgb(radiance));
    builder.box({0, 0, 0}, {4, 3, 2.5F}, {m, m, m, m, m, m}, true);
    if (furnished) {
        builder.solid({1, 1, 0.2F}, {1.7F, 1.8F, 0.9F}, m);
        builder.sphere({2.8F, 1.4F, 0.8F}, 0.5F, 24, m, false);
    }
    return builder.description;
}

TEST(EnergyLaws, furnace_radiosity_is_emission_over_one_minus_albedo_in_an_empty_room) {
    Prepared prepared(furnace(0.5F, false));
    const auto solution = prepared.solve();
    const Extremes b = leaf_radiosity(*solution, front);
    EXPECT_NEAR(b.mean, 2.0, 0.004);
    EXPECT_NEAR(b.least, 2.0, 0.02);
    EXPECT_NEAR(b.most, 2.0, 0.02);
}

TEST(EnergyLaws, furnace_radiosity_is_emission_over_one_minus_albedo_around_furniture) {
    Prepared prepared(furnace(0.5F, true));
    const auto solution = prepared.solve();
    const Extremes b = leaf_radiosity(*solution, front);
    EXPECT_NEAR(b.mean, 2.0, 0.01);
    EXPECT_NEAR(b.least, 2.0, 0.2);
    EXPECT_NEAR(b.most, 2.0, 0.2);
    printf("%s\n", prepared.statistics.json().c_str());
}

// A lamp in a closed room: what is emitted is absorbed.
TEST(EnergyLaws, closed_room_absorbs_what_its_lamp_emits) {
    SceneBuilder builder;
    const std::uint32_t grey = builder.material(Rgb(0.6F));
    builder.box({0, 0, 0}, {4, 3, 2.5F}, {grey, grey, grey, grey, grey, grey}, true);
    builder.solid({1, 1, 0}, {1.7F, 1.8F, 0.9F}, grey);
    builder.sphere({2.8F, 1.4F, 0.8F}, 0.5F, 24, grey, false);
    builder.area_light({2, 1.5F, 2.4F}, {0, 0, -1}, 1, Rgb(100));
    Prepared prepared(builder.description);
    const auto solution = prepared.solve();
    double absorbed = 0;
    for (NodeId id = 0; id < solution->hierarchy.nodes().size(); ++id) {
        const Node& node = solution->hierarchy[id];
        if (is_surface(node) && node.child_count == 0) {
            absorbed += solution->lighting.area(id) * 0.4 * luminance(solution->lighting.irradiance(id));
        }
    }
    const Lamp& lamp = prepared.scene.lamps[0];
    const double emitted = kPi * luminance(lamp.radiance) * 4 * length(cross(lamp.half_x, lamp.half_y));
    printf("%s\n", prepared.statistics.json().c_str());
    EXPECT_NEAR(absorbed / emitted, 1.0, 0.02);
}

// H = (sum A_j E_j / A) / (1 - sum A_j rho_j / A), B_j = E_j + rho_j H, exact for a sphere [integrating sphere].
TEST(EnergyLaws, integrating_sphere) {
    SceneBuilder builder;
    const std::uint32_t m = builder.material(Rgb(0.8F, 0.5F, 0.2F), Rgb(1 / kPi));
    builder.sphere({0, 0, 0}, 2, 32, m, true);
    Prepared prepared(builder.description);
    const auto solution = prepared.solve();
    const Rgb mean = solution->lighting.radiosity(kGeometryRoot);
    EXPECT_NEAR(mean.r, 1 / (1 - 0.8F), 0.005F * 5);
    EXPECT_NEAR(mean.g, 1 / (1 - 0.5F), 0.005F * 2);
    EXPECT_NEAR(mean.b, 1 / (1 - 0.2F), 0.005F * 1.25F);
}

}  // namespace
}  // namespace gg::test
