// Rays of elements that are long and thin, and bright.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "oracles/path_irradiance.h"
#include "support/solution_measures.h"
#include "support/test_scenes.h"

namespace gg::test {
namespace {

// A bar of 1.2 m x 6 cm (instance 0) that looks at a large black wall 11 cm before it, below a lamp between them.
SceneDescription bar_before_wall(float half_wall) {
    constexpr float kGap = 0.11F;
    SceneBuilder builder;
    builder.quad({-0.6F, 0, -0.03F}, {0.6F, 0, -0.03F}, {0.6F, 0, 0.03F}, {-0.6F, 0, 0.03F},
                 builder.material(Rgb(0.7F)), "bar");
    const float w = half_wall;
    builder.quad({-w, -kGap, -w}, {-w, -kGap, w}, {w, -kGap, w}, {w, -kGap, -w}, builder.material(Rgb(0.0F)), "wall");
    builder.area_light({0, -0.06F, 0.4F}, {0, 0, -1}, 0.08F, Rgb(20));
    builder.description.lights.back().to_world.linear = Mat3(1.0F);
    builder.description.lights.back().size_x = 0.6F;
    return builder.description;
}

// Of the bar's leaf elements.
std::vector<double> found_over_true(float half_wall) {
    Prepared prepared(bar_before_wall(half_wall));
    const auto solution = prepared.solve(0.05F);
    const oracle::WalkedScene walked{prepared.scene, *prepared.colors, *prepared.tracer};
    std::vector<double> ratios;
    for (const NodeId id : surface_leaves(*solution)) {
        const Node& node = solution->hierarchy[id];
        if (node.kind == NodeKind::kElement && node.instance == 0 && !node.back) {
            const double truth = luminance_of(oracle::mean_irradiance(walked, solution->hierarchy, node, 20000));
            ratios.push_back(luminance(solution->lighting.irradiance(id)) / truth);
        }
    }
    return ratios;
}

// The wall is nearer than an element is long, but does not cover it. The bar is brighter than most, so its noise is
// small.
TEST(ThinElements, a_bar_close_to_a_wall_keeps_its_light) {
    for (const float half_wall : {4.0F, 15.0F}) {
        const std::vector<double> ratios = found_over_true(half_wall);
        EXPECT_GT(ratios.size(), 50U);
        double squares = 0;
        for (const double ratio : ratios) {
            EXPECT_NEAR(ratio, 1, 0.15);
            squares += (ratio - 1) * (ratio - 1) / static_cast<double>(ratios.size());
        }
        EXPECT_LT(std::sqrt(squares), 0.04);  // 0.08 without the rays that bright elements have more of
    }
}

}  // namespace
}  // namespace gg::test
