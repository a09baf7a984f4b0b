// What covers parts of large faces is found, and light is shared out to the rest.
#include "radiosity/patches.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "radiosity/quarter.h"
#include "support/law_scenes.h"
#include "support/solution_measures.h"

namespace gg::test {
namespace {

// A floor of 4 x 4 m with a slab over the quarter x > 2, y > 2, this high above it.
SceneDescription covered_floor(float gap) {
    SceneBuilder builder;
    const std::uint32_t grey = builder.material(Rgb(0.5F));
    builder.quad({0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, grey, "floor");
    builder.solid({2, 2, gap}, {4, 4, gap + 0.2F}, grey, "slab");
    builder.area_light({1, 1, 3}, {0, 0, -1}, 1, Rgb(100));
    return builder.description;
}

// Mean exposure of the floor's front over x0..x1, y0..y1.
float exposure_over(const Prepared& prepared, const PatchForest& forest, Vec2 low, Vec2 high) {
    float sum = 0;
    constexpr int kGrid = 16;
    for (int i = 0; i < kGrid * kGrid; ++i) {
        const Vec2 p = low + (Vec2(i % kGrid, i / kGrid) + 0.5F) / static_cast<float>(kGrid) * (high - low);
        for (std::uint32_t triangle = 0; triangle < 2; ++triangle) {
            const auto c = world_triangle(prepared.scene, 0, triangle);
            const Vec3 e1 = c[1] - c[0], e2 = c[2] - c[0], d = Vec3(p, 0) - c[0];
            const float determinant = e1.x * e2.y - e1.y * e2.x;
            Vec2 place((d.x * e2.y - d.y * e2.x) / determinant, (e1.x * d.y - e1.y * d.x) / determinant);
            if (place.x < 0 || place.y < 0 || place.x + place.y > 1) {
                continue;
            }
            std::uint32_t patch = forest.root(0, triangle, false);
            while (forest.is_open(patch)) {
                const int quarter = quarter_at(place);
                place = place_in_quarter(place, quarter);
                patch = forest.patches[patch].first_child + quarter;
            }
            sum += patch == kNone ? 1.0F : forest.patches[patch].exposure;
            break;
        }
    }
    return sum / (kGrid * kGrid);
}

TEST(Patches, what_lies_under_a_slab_is_covered_and_the_rest_is_not) {
    Prepared prepared(covered_floor(0.02F));
    const PatchForest forest =
        find_patches(prepared.scene, std::vector<std::uint32_t>{0, 1}, 0.1F, *prepared.tracer, prepared.control);
    EXPECT_LT(exposure_over(prepared, forest, {2.2F, 2.2F}, {4, 4}), 0.04F);
    EXPECT_GT(exposure_over(prepared, forest, {0, 0}, {1.8F, 4}), 0.98F);
    for (const Patch& patch : forest.patches) {
        if (patch.first_child == kNone) {
            EXPECT_GE(patch.exposure, 0);
            EXPECT_LE(patch.exposure, 1);
            continue;
        }
        float mean = 0;
        for (int quarter = 0; quarter < kQuarters; ++quarter) {
            mean += forest.patches[patch.first_child + quarter].exposure / kQuarters;
        }
        EXPECT_NEAR(patch.exposure, mean, 1e-6F);
    }
}

TEST(Patches, an_empty_room_has_none) {
    Prepared prepared(furnace(0.5F, false));
    const PatchForest forest = find_patches(prepared.scene, std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}, 0.09F,
                                            *prepared.tracer, prepared.control);
    for (const Patch& patch : forest.patches) {
        EXPECT_GT(patch.exposure, 0.5F);
    }
}

TEST(Patches, no_detail_or_no_large_face_means_no_patches) {
    Prepared prepared(covered_floor(0.02F));
    const std::vector<std::uint32_t> all{0, 1};
    EXPECT_TRUE(find_patches(prepared.scene, all, 0, *prepared.tracer, prepared.control).patches.empty());
    EXPECT_TRUE(find_patches(prepared.scene, all, 10, *prepared.tracer, prepared.control).patches.empty());
    EXPECT_EQ(find_patches(prepared.scene, all, 0.1F, *prepared.tracer, prepared.control).root(7, 0, false), kNone);
}

// The covered part neither darkens what lies beside it nor shines itself.
TEST(Patches, light_lands_beside_a_slab) {
    Prepared covered(covered_floor(0.02F));
    SceneDescription without = covered_floor(0.02F);
    without.instances.resize(1);
    Prepared open(without);
    const auto ours = covered.solve(0.02F);
    const auto truth = open.solve(0.02F);
    for (const Vec2 p : {Vec2(1.75F, 3), Vec2(3, 1.75F), Vec2(1.8F, 1.8F)}) {
        // The floor's first triangle is below its diagonal.
        const bool upper = p.y > p.x;
        const Vec2 place = upper ? Vec2(p.x / 4, (p.y - p.x) / 4) : Vec2((p.x - p.y) / 4, p.y / 4);
        const auto at = [&](const Solution& solution) {
            return luminance(interpolated_irradiance(solution, 0, upper ? 1 : 0, false, place));
        };
        EXPECT_GT(at(*ours) / at(*truth), 0.8F) << p.x << " " << p.y;
    }
    const auto below = luminance(interpolated_irradiance(*ours, 0, 0, false, {0.125F, 0.75F}));
    EXPECT_LT(below, 0.05F * luminance(interpolated_irradiance(*truth, 0, 0, false, {0.125F, 0.75F})));
}

}  // namespace
}  // namespace gg::test
