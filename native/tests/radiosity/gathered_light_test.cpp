// What faces of clusters and elements see by rays of their own.
#include "radiosity/gathered_light.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <span>

#include "support/law_scenes.h"
#include "support/meshes.h"
#include "transport/emitter_sampling.h"
#include "transport/form_factor.h"

namespace gg::test {
namespace {

// body(triangle, its outward irradiance) for the faces of the first instance that stayed in clusters; returns how many.
template <typename Body>
int for_each_cluster_face(const Prepared& prepared, const Solution& solution, const Body& body) {
    int count = 0;
    for (std::uint32_t triangle = 0; triangle < prepared.scene.meshes[0].triangles.size(); ++triangle) {
        if (solution.elements.of(0, triangle, false) == kNone) {
            body(triangle, luminance(solution.face_light.irradiance(0, triangle, false)));
            ++count;
        }
    }
    return count;
}

// A sphere of 48 rings above a black field so far away and so large that the sphere stays in clusters.
void add_small_sphere(SceneBuilder& builder) {
    builder.sphere({0, 0, 0}, 0.1F, 48, builder.material(Rgb(0.5F)), false);
    builder.quad({-20, -20, -60}, {20, -20, -60}, {20, 20, -60}, {-20, 20, -60}, builder.material(Rgb(0.0F)));
}

TEST(GatheredLight, convex_body_below_an_even_sky_has_pi_everywhere) {
    SceneBuilder builder;
    builder.description.world = Rgb(1.0F);
    add_small_sphere(builder);
    Prepared prepared(builder.description);
    const auto solution = prepared.solve();
    double mean = 0;
    const int count = for_each_cluster_face(prepared, *solution, [&](std::uint32_t triangle, float e) {
        const float up = normalize(world_area_vector(prepared.scene, 0, triangle)).z;
        if (up > 0.2F) {  // does not see the field
            EXPECT_NEAR(e, kPi, 1e-3F) << triangle;
        }
        mean += e;
    });
    EXPECT_GT(mean / count, 0.9F * kPi);
    EXPECT_GT(count, 100);
}

TEST(GatheredLight, sphere_below_a_sun_has_the_cosine) {
    SceneBuilder builder;
    builder.sun({0, 0, -1}, Rgb(10));
    add_small_sphere(builder);
    Prepared prepared(builder.description);
    const auto solution = prepared.solve();
    const int count = for_each_cluster_face(prepared, *solution, [&](std::uint32_t triangle, float e) {
        const float cosine = normalize(world_area_vector(prepared.scene, 0, triangle)).z;
        EXPECT_NEAR(e, 10 * std::max(0.0F, cosine), 2.5F) << triangle;  // groups are a tenth of the sphere wide
        if (cosine < -0.3F) {
            EXPECT_LT(e, 1e-5F) << triangle;
        }
    });
    EXPECT_GT(count, 100);
}

// A room of 4 x 4 x 2.5 m with a grey floor and a hole of 80 cm in its black ceiling, below an even sky.
SceneDescription room_with_a_skylight() {
    SceneBuilder builder;
    const auto black = builder.material(Rgb(0.0F));
    builder.quad({-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}, builder.material(Rgb(0.5F)), "floor");
    builder.solid({-2.1F, -2, -0.1F}, {-2, 2, 2.6F}, black, "wall");
    builder.solid({2, -2, -0.1F}, {2.1F, 2, 2.6F}, black, "wall");
    builder.solid({-2.1F, -2.1F, -0.1F}, {2.1F, -2, 2.6F}, black, "wall");
    builder.solid({-2.1F, 2, -0.1F}, {2.1F, 2.1F, 2.6F}, black, "wall");
    constexpr float a = 0.8F, b = 1.6F;
    builder.quad({-2, -2, 2.5F}, {-2, 2, 2.5F}, {a, 2, 2.5F}, {a, -2, 2.5F}, black, "ceiling");
    builder.quad({b, -2, 2.5F}, {b, 2, 2.5F}, {2, 2, 2.5F}, {2, -2, 2.5F}, black, "ceiling");
    builder.quad({a, -2, 2.5F}, {a, a, 2.5F}, {b, a, 2.5F}, {b, -2, 2.5F}, black, "ceiling");
    builder.quad({a, b, 2.5F}, {a, 2, 2.5F}, {b, 2, 2.5F}, {b, b, 2.5F}, black, "ceiling");
    builder.description.world = Rgb(1.0F);
    return builder.description;
}

// The window is between 0.5 and 3 % of the hemisphere.
TEST(GatheredLight, sky_through_a_small_window_has_its_form_factor) {
    Prepared prepared(room_with_a_skylight());
    const auto solution = prepared.solve(0.005F);
    const std::array<Vec3, 4> window{
        Vec3{0.8F, 0.8F, 2.5F}, {0.8F, 1.6F, 2.5F}, {1.6F, 1.6F, 2.5F}, {1.6F, 0.8F, 2.5F}};
    double exact = 0, found = 0, squares = 0, area = 0;
    for (NodeId id = 0; id < solution->hierarchy.nodes().size(); ++id) {
        const Node& node = solution->hierarchy[id];
        if (node.kind == NodeKind::kElement && node.child_count == 0 && node.instance == 0 && !node.back &&
            node.weight == 1) {
            const float e = kPi * std::abs(vector_form_factor(node.center, std::span<const Vec3>(window)).z);
            const float ours = luminance(solution->lighting.irradiance(id));
            exact += node.area * e;
            found += node.area * ours;
            squares += node.area * (ours - e) * (ours - e);
            area += node.area;
        }
    }
    EXPECT_NEAR(found / exact, 1, 0.02);
    EXPECT_LT(std::sqrt(squares / area) / (exact / area), 0.16);
}

}  // namespace
}  // namespace gg::test
