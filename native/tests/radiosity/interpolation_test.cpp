// Interpolated irradiance is continuous over elements, T-vertices and triangles that share shading vertices.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/random.h"
#include "support/law_scenes.h"
#include "support/solution_measures.h"

namespace gg::test {
namespace {

// A wall of one quad (instance 0) behind a pole, so that a shadow with two edges falls on it.
SceneDescription shadowed_wall() {
    SceneBuilder builder;
    const std::uint32_t grey = builder.material(Rgb(0.5F));
    builder.quad({0, 0, 0}, {2, 0, 0}, {2, 1.5F, 0}, {0, 1.5F, 0}, grey, "wall");
    builder.solid({0.9F, -0.2F, 0.4F}, {1.15F, 1.1F, 0.6F}, grey, "pole");
    builder.area_light({1, 0.7F, 1.5F}, {0, 0, -1}, 0.15F, Rgb(100));
    return builder.description;
}

// The wall's triangles are (a, b, c) and (a, c, d); x along a-b, y along a-d, both 0..1.
Rgb wall_at(const Solution& solution, double x, double y, bool upper) {
    const Vec2 weights(static_cast<float>(upper ? x : x - y), static_cast<float>(upper ? y - x : y));
    return interpolated_irradiance(solution, 0, upper ? 1 : 0, false, weights);
}

class Interpolation : public testing::Test {
  protected:
    Prepared prepared_{shadowed_wall()};
    std::shared_ptr<const Solution> solution_ = prepared_.solve(0.01F);
};

TEST_F(Interpolation, has_something_to_show) {
    std::size_t leaves = 0, t_vertices = 0;
    float least = kInfinity, most = 0;
    for (const NodeId id : surface_leaves(*solution_)) {
        const Node& node = solution_->hierarchy[id];
        if (node.kind == NodeKind::kElement && node.instance == 0 && !node.back) {
            ++leaves;
            t_vertices += solution_->element_vertices[id].has_t_vertices;
            least = std::min(least, luminance(solution_->lighting.irradiance(id)));
            most = std::max(most, luminance(solution_->lighting.irradiance(id)));
        }
    }
    EXPECT_GT(leaves, 200U);
    EXPECT_GT(t_vertices, 50U);
    EXPECT_LT(least, 0.2F * most);
}

// Values of a piecewise linear function are bounded by its steepest piece: halving the step halves the largest jump.
TEST_F(Interpolation, jumps_shrink_with_the_step) {
    constexpr int kSteps = 100000;
    for (std::uint32_t walk = 0; walk < 4; ++walk) {
        const Sequence4 sequence(walk);
        const Vec2 from(sequence(0, 0), sequence(0, 1)), to(sequence(0, 2), sequence(0, 3));
        const auto largest_jump = [&](int steps) {
            float largest = 0, before = 0;
            for (int i = 0; i <= steps; ++i) {
                const double share = static_cast<double>(i) / steps;
                const double x = from.x + share * (to.x - from.x), y = from.y + share * (to.y - from.y);
                const float now = luminance(wall_at(*solution_, x, y, y > x));
                largest = i > 0 ? std::max(largest, std::abs(now - before)) : 0;
                before = now;
            }
            return largest;
        };
        const float coarse = largest_jump(kSteps / 10), fine = largest_jump(kSteps);
        EXPECT_GT(coarse, 0) << walk;
        EXPECT_LT(fine, 0.15F * coarse) << walk;
    }
}

// Both sides of every edge of every leaf element, at places that no T-vertex hits on purpose.
TEST_F(Interpolation, agrees_on_both_sides_of_every_edge) {
    float brightest = 0;
    for (const NodeId id : surface_leaves(*solution_)) {
        brightest = std::max(brightest, luminance(solution_->lighting.irradiance(id)));
    }
    std::size_t compared = 0;
    for (const NodeId id : surface_leaves(*solution_)) {
        const Node& node = solution_->hierarchy[id];
        if (node.kind != NodeKind::kElement || node.instance != 0 || node.back) {
            continue;
        }
        const Vec2 middle = (node.weights[0] + node.weights[1] + node.weights[2]) / 3.0F;
        for (int k = 0; k < 3; ++k) {
            for (const float share : {0.11F, 0.25F, 0.47F, 0.5F, 0.83F}) {
                const Vec2 on = node.weights[k] + share * (node.weights[(k + 1) % 3] - node.weights[k]);
                const Vec2 inward = (middle - on) * 2e-5F;
                const Vec2 inside = on + inward, outside = on - inward;
                if (std::min({outside.x, outside.y, 1 - outside.x - outside.y}) < 0) {
                    continue;  // another triangle
                }
                const float a = luminance(interpolated_irradiance(*solution_, 0, node.source, false, inside));
                const float b = luminance(interpolated_irradiance(*solution_, 0, node.source, false, outside));
                // Over a leaf the light can change by all of its brightness, between these points by 1e-4 of that.
                ASSERT_NEAR(a, b, 1e-4F * brightest) << "element " << id << " edge " << k << " at " << share;
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 2000U);
}

TEST_F(Interpolation, agrees_between_triangles_along_their_common_edge) {
    for (int i = 0; i <= 1000; ++i) {
        const double x = i / 1000.0;
        const float lower = luminance(wall_at(*solution_, x, x, false));
        const float upper = luminance(wall_at(*solution_, x, x, true));
        ASSERT_NEAR(lower, upper, 1e-5F * std::max(lower, 1.0F)) << x;
    }
}

// Corners of triangles of the sphere that share a shading vertex, whether the sphere stayed in clusters or not.
TEST(InterpolationOfMeshes, corners_that_share_a_shading_vertex_agree) {
    Prepared prepared(mixed_scene());
    const auto solution = prepared.solve(0.02F);
    const Vec2 corners[3] = {{0, 0}, {1, 0}, {0, 1}};
    std::size_t shared = 0;
    for (std::uint32_t instance = 0; instance < prepared.scene.instances.size(); ++instance) {
        const Mesh& mesh = prepared.scene.meshes[prepared.scene.instances[instance].mesh];
        std::vector<Rgb> values(mesh.normals.size(), Rgb(-1.0F));
        for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
            for (int k = 0; k < 3; ++k) {
                Rgb& value = values[mesh.shading_vertices[triangle][k]];
                const Rgb here = interpolated_irradiance(*solution, instance, triangle, false, corners[k]);
                shared += value.x >= 0;
                ASSERT_TRUE(value.x < 0 || value == here) << instance << " " << triangle;
                value = here;
            }
        }
    }
    EXPECT_GT(shared, 1000U);
}

TEST(InterpolationOfMeshes, back_of_a_closed_solid_is_dark) {
    Prepared prepared(mixed_scene());
    const auto solution = prepared.solve(0.02F);
    constexpr std::uint32_t kCube = 5, kSphere = 6;
    for (const std::uint32_t instance : {kCube, kSphere}) {
        const Mesh& mesh = prepared.scene.meshes[prepared.scene.instances[instance].mesh];
        float brightest = 0;
        for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
            ASSERT_EQ(interpolated_irradiance(*solution, instance, triangle, true, {0.2F, 0.3F}), Rgb(0.0F));
            brightest = std::max(
                brightest, luminance(interpolated_irradiance(*solution, instance, triangle, false, {0.2F, 0.3F})));
        }
        EXPECT_GT(brightest, 1);
    }
}

// The mean over a wall of the interpolated irradiance is that of its elements: averaging at vertices moves light by an
// element or two, but loses none.
TEST_F(Interpolation, keeps_the_mean) {
    constexpr int kGrid = 300;
    double mean = 0;
    for (int i = 0; i < kGrid * kGrid; ++i) {
        const double x = (i % kGrid + 0.5) / kGrid, y = (i / kGrid + 0.51) / kGrid;
        mean += luminance(wall_at(*solution_, x, y, y > x)) / (kGrid * kGrid);
    }
    const FaceMeans elements = means_of(*solution_, [](const Node& node) { return node.instance == 0 && !node.back; });
    EXPECT_NEAR(mean / luminance_of(elements.irradiance), 1, 0.01);
}

}  // namespace
}  // namespace gg::test
