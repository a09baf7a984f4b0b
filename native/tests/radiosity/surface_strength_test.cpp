// How much divided triangles count: not where they are smaller than wanted, or coarser than the solution's elements.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/meshes.h"
#include "support/surface_meshes.h"

namespace gg::test {
namespace {

class FadingFloor : public testing::Test {
  protected:
    Prepared prepared_{lit_floor()};
    std::shared_ptr<const Solution> solution_ = prepared_.solve();
    std::vector<SurfaceSpot> spots_ = raster(prepared_.scene, 0, 64);
};

// The height of the quad's triangles is 2.83 m.
TEST_F(FadingFloor, strength_fades_as_triangles_become_smaller_than_wanted) {
    const float height = 2 * std::sqrt(2.0F);
    for (float size = 0.5F; size < 3; size *= 1.02F) {  // heights over sides that are wanted
        const SurfaceMesh mesh = divided(*solution_, {even(height / size)}, spots_);
        for (std::size_t i = 0; i < spots_.size(); i += 97) {
            ASSERT_NEAR(mesh.place(spots_[i]).sum(), glm::smoothstep(1.0F, 2.0F, size), 1e-5F) << size;
        }
    }
}

TEST_F(FadingFloor, what_is_not_seen_has_no_vertices) {
    const SurfaceMesh mesh = divided(*solution_, {even(0.3F)}, {{0, 0, false, {0.2F, 0.3F}}});
    EXPECT_EQ(mesh.vertex_count(), 3U);
    EXPECT_NEAR(mesh.place({0, 0, false, {0.2F, 0.3F}}).sum(), 1, 1e-5F);
    EXPECT_EQ(mesh.place({0, 0, true, {0.2F, 0.3F}}).sum(), 0);
    EXPECT_EQ(mesh.place({0, 0, false, {0.8F, 0.1F}}).sum(), 0);
}

// As published: nothing where the solution's own elements are coarser.
TEST_F(FadingFloor, elements_alone_count_as_far_as_they_are_fine_enough) {
    const SurfaceMesh mesh = divided(*solution_, {even(0.3F), true}, spots_);
    int coarse = 0, fine = 0, counts = 0;
    for (const SurfaceSpot& spot : spots_) {
        const NodeId leaf = place_at(*solution_, 0, spot.triangle, false, position_of(prepared_.scene, spot));
        const float sum = mesh.place(spot).sum();
        if (solution_->hierarchy[leaf].depth < mesh.part_at(spot).depth) {
            ASSERT_EQ(sum, 0);
            ++coarse;
        } else {
            ++fine;
            counts += sum > 0.999F ? 1 : 0;
        }
    }
    EXPECT_GT(coarse, 100);
    EXPECT_GT(fine, 100);
    EXPECT_GT(counts, fine / 4);
}

// Strips of 1 m, each narrower than the one to its left, down to 2 cm.
MeshDescription strips(bool narrow_first) {
    std::vector<Vec3> corners;
    std::vector<std::uint32_t> triangles;
    std::uint32_t column = 0;
    for (float x = 0, width = 1; width > 0.02F; x += width, width *= 0.8F, ++column) {
        corners.insert(corners.end(), {{x, 0, 0}, {x, 1, 0}});
        if (column > 0) {
            const std::uint32_t a = 2 * column - 2;
            triangles.insert(narrow_first ? triangles.begin() : triangles.end(), {a, a + 2, a + 3, a, a + 3, a + 1});
        }
    }
    return make_mesh(corners, triangles);
}

class Strips : public testing::TestWithParam<bool> {
  protected:
    static SceneDescription scene() {
        SceneBuilder builder;
        builder.add_mesh(strips(GetParam()), builder.material(Rgb(0.5F)));
        builder.point_light({1, 0.5F, 1}, Rgb(10));
        return builder.description;
    }

    static constexpr float kSide = 0.2F;
    Prepared prepared_{scene()};
    std::shared_ptr<const Solution> solution_ = prepared_.solve();
    SurfaceMesh mesh_ = divided(*solution_, {even(kSide)}, raster(prepared_.scene, 0, 64));
};
INSTANTIATE_TEST_SUITE_P(Surface, Strips, testing::Bool());

// By that triangle's height.
TEST_P(Strips, vertices_count_as_much_as_the_smallest_triangle_around_them) {
    const auto& triangles = prepared_.description.meshes[0].triangle_vertices;
    std::vector<float> strength(prepared_.description.meshes[0].positions.size(), 1);
    for (std::uint32_t t = 0; t < triangles.size() / 3; ++t) {
        const auto c = world_triangle(prepared_.scene, 0, t);
        const float longest = std::max({length(c[1] - c[0]), length(c[2] - c[1]), length(c[0] - c[2])});
        const float height = length(cross(c[1] - c[0], c[2] - c[0])) / longest;
        for (std::uint32_t k = 0; k < 3; ++k) {
            float& least = strength[triangles[3 * t + k]];
            least = std::min(least, glm::smoothstep(1.0F, 2.0F, height / kSide));
        }
    }
    int fading = 0, none = 0;
    for (std::uint32_t t = 0; t < triangles.size() / 3; ++t) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const float expected = strength[triangles[3 * t + k]];
            const float found = mesh_.place({0, t, false, {k == 1 ? 1 : 0, k == 2 ? 1 : 0}}).sum();
            ASSERT_NEAR(found, expected, 1e-4F) << t << " " << k;
            fading += expected > 0 && expected < 1 ? 1 : 0;
            none += expected == 0 ? 1 : 0;
        }
    }
    EXPECT_GE(fading, 6);
    EXPECT_GE(none, 20);
}

TEST_P(Strips, fade_without_a_step) {
    const auto sum_at = [&](float x, float y) {
        const Hit hit = prepared_.tracer->closest_hit({{x, y, 0.5F}, {0, 0, -1}}, RayMask::kCamera);
        return mesh_.place({0, hit.triangle, false, {hit.u, hit.v}}).sum();
    };
    for (int row = 0; row < 10; ++row) {
        const float y = (static_cast<float>(row) + 0.37F) / 10;
        float before = sum_at(0.001F, y);
        EXPECT_NEAR(before, 1, 1e-4F);
        for (int i = 1; i < 20000; ++i) {
            const float now = sum_at(0.001F + 4.7F * static_cast<float>(i) / 20000, y);
            ASSERT_NEAR(now, before, 0.01F) << i << " " << y;  // 0.24 mm in parts of at least 5 cm
            before = now;
        }
        EXPECT_EQ(before, 0);
    }
}

// A finely divided sphere, small in a large scene.
TEST(SurfaceStrength, faces_in_clusters_are_no_elements) {
    SceneBuilder builder;
    builder.sphere({0, 0, 0}, 0.1F, 48, builder.material(Rgb(0.5F)), false);
    builder.quad({-20, -20, -60}, {20, -20, -60}, {20, 20, -60}, {-20, 20, -60}, builder.material(Rgb(0.0F)));
    builder.description.world = Rgb(1.0F);
    Prepared prepared(builder.description);
    const auto solution = prepared.solve();
    const std::vector<SurfaceSpot> spots = raster(prepared.scene, 0, 2);
    const SurfaceMesh all = divided(*solution, {even(1e-4F)}, spots);
    const SurfaceMesh alone = divided(*solution, {even(1e-4F), true}, spots);
    int in_clusters = 0;
    for (const SurfaceSpot& spot : spots) {
        if (solution->elements.of(0, spot.triangle, false) == kNone) {
            EXPECT_GT(all.place(spot).sum(), 0.999F);
            EXPECT_EQ(alone.place(spot).sum(), 0);
            ++in_clusters;
        }
    }
    EXPECT_GT(in_clusters, 1000);
}

}  // namespace
}  // namespace gg::test
