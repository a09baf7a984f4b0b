// What faces of clusters and elements see by rays of their own.
#include "radiosity/gathered_light.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/law_scenes.h"
#include "support/meshes.h"
#include "transport/emitter_sampling.h"

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

}  // namespace
}  // namespace gg::test
