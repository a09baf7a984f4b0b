// Finer settings come closer to one solution, and sweeps over fixed links come to rest.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "radiosity/reference_white.h"
#include "radiosity/refine.h"
#include "support/law_scenes.h"
#include "support/solution_measures.h"

namespace gg::test {
namespace {

// Irradiance over a grid on each wall of a room, luminance, W/m2.
std::vector<double> wall_irradiance(const Solution& solution) {
    constexpr int kGrid = 12;
    std::vector<double> values;
    for (std::uint32_t instance = 0; instance < 6; ++instance) {
        for (std::uint32_t triangle = 0; triangle < 2; ++triangle) {
            for (int i = 0; i < kGrid * kGrid; ++i) {
                const Vec2 w((static_cast<float>(i % kGrid) + 0.5F) / kGrid,
                             (static_cast<float>(i / kGrid) + 0.5F) / kGrid);
                if (w.x + w.y < 1) {
                    values.push_back(luminance(interpolated_irradiance(solution, instance, triangle, false, w)));
                }
            }
        }
    }
    return values;
}

// Root mean square over the mean.
double difference(const std::vector<double>& a, const std::vector<double>& b) {
    double squares = 0, sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        squares += (a[i] - b[i]) * (a[i] - b[i]);
        sum += b[i];
    }
    const auto count = static_cast<double>(a.size());
    return std::sqrt(squares / count) / (sum / count);
}

TEST(Convergence, finer_solutions_come_closer_to_the_finest) {
    Prepared prepared(lamp_room(0.6F));
    const auto finest = wall_irradiance(*prepared.solve(0.0025F));
    std::vector<double> errors;
    for (const float quality : {0.16F, 0.04F, 0.01F}) {
        errors.push_back(difference(wall_irradiance(*prepared.solve(quality)), finest));
    }
    EXPECT_LT(errors[1], 0.8 * errors[0]);
    EXPECT_LT(errors[2], 0.85 * errors[1]);
    EXPECT_LT(errors[2], 0.07);
}

// At every sweep after the first few, the change shrinks by about the mean reflectance.
TEST(Convergence, sweeps_come_to_rest) {
    Prepared prepared(lamp_room(0.6F));
    Solution solution(prepared.scene, *prepared.colors, prepared.faces());
    solution.lighting.grow(prepared.control);
    solution.links = initial_links(solution.hierarchy);
    refine(solution.hierarchy, solution.lighting, *prepared.tracer, solution.links,
           {0.2F, reference_white(solution.hierarchy, solution.lighting)}, prepared.control, prepared.statistics);
    solution.lighting.set_links(solution.links, prepared.control);
    double before = 1;
    for (int sweep = 0; sweep < 25; ++sweep) {
        const double change = solution.lighting.iterate(prepared.control);
        EXPECT_LT(change, sweep > 2 ? 0.8 * before + 1e-6 : 1.01) << "sweep " << sweep;
        before = change;
    }
    EXPECT_LT(before, 1e-5);
}

TEST(Convergence, scene_without_light_is_dark) {
    SceneBuilder builder;
    const std::uint32_t grey = builder.material(Rgb(0.5F));
    builder.box(Vec3(0.0F), kRoomSize, {grey, grey, grey, grey, grey, grey}, true);
    add_furniture(builder, grey);
    Prepared prepared(builder.description);
    const auto solution = prepared.solve();
    for (NodeId id = 0; id < solution->hierarchy.nodes().size(); ++id) {
        EXPECT_EQ(solution->lighting.radiosity(id), Rgb(0.0F));
    }
}

TEST(Convergence, empty_scene_has_a_solution) {
    SceneBuilder builder;
    builder.description.world = Rgb(1.0F);
    builder.area_light({0, 0, 1}, {0, 0, -1}, 1, Rgb(10));
    Prepared prepared(builder.description);
    EXPECT_TRUE(surface_leaves(*prepared.solve()).size() <= 1);
}

}  // namespace
}  // namespace gg::test
