#include "material/surface_color.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/control.h"
#include "core/messages.h"
#include "core/random.h"
#include "scene/load_textures.h"

namespace gg {
namespace {

const Vec2 kCorners[3] = {{0.1F, 0.1F}, {0.9F, 0.2F}, {0.3F, 0.8F}};

// Linear RGBA pixels; values need not be bytes.
ImageDescription make_image(std::uint32_t width, std::uint32_t height, const std::vector<Rgb>& colors) {
    ImageDescription image;
    image.name = "image";
    image.color_space = ColorSpace::kLinear;
    image.width = width;
    image.height = height;
    for (const Rgb& color : colors) {
        image.pixels.insert(image.pixels.end(), {color.r, color.g, color.b, 1});
    }
    return image;
}

struct Materials {
    SceneDescription description;
    Messages messages;
    TextureSet textures;

    ColorInput& add(Rgb reflectance, Rgb emission = Rgb(0)) {
        MaterialDescription& material = description.materials.emplace_back();
        material.name = "material";
        material.reflectance.factor = reflectance;
        material.emission.factor = emission;
        return material.reflectance;
    }
    SurfaceColors colors() {
        textures = load_textures(description, Control{}, messages);
        Scene scene;
        scene.materials = description.materials;
        return {scene, textures, messages};
    }
};

TEST(SurfaceColor, constant_colours_are_the_same_everywhere_and_in_the_mean) {
    Materials materials;
    materials.add(Rgb(0.1F, 0.5F, 0.9F), Rgb(3, 0, 100));
    const SurfaceColors colors = materials.colors();
    EXPECT_EQ(colors.reflectance_at(0, {7, -3}, 0.5F), Rgb(0.1F, 0.5F, 0.9F));
    EXPECT_EQ(colors.mean_reflectance(0, kCorners[0], kCorners[1], kCorners[2]), Rgb(0.1F, 0.5F, 0.9F));
    EXPECT_EQ(colors.emission_at(0, {0, 0}, 0), Rgb(3, 0, 100));
    EXPECT_EQ(colors.mean_emission(0, kCorners[0], kCorners[1], kCorners[2]), Rgb(3, 0, 100));
    EXPECT_FALSE(colors.is_textured(0));
    EXPECT_TRUE(colors.emits(0));
    EXPECT_TRUE(materials.messages.all().empty());
}

TEST(SurfaceColor, no_material_and_unknown_ones_are_grey_and_dark) {
    Materials materials;
    const SurfaceColors colors = materials.colors();
    for (const std::uint32_t material : {kNone, 0U, 17U}) {
        EXPECT_EQ(colors.reflectance_at(material, {0, 0}, 0), Rgb(0.8F));
        EXPECT_EQ(colors.mean_reflectance(material, kCorners[0], kCorners[1], kCorners[2]), Rgb(0.8F));
        EXPECT_EQ(colors.emission_at(material, {0, 0}, 0), Rgb(0));
        EXPECT_FALSE(colors.emits(material));
        EXPECT_FALSE(colors.is_textured(material));
    }
}

TEST(SurfaceColor, reflectance_stays_below_one_so_that_light_dies_out) {
    Materials materials;
    materials.description.images = {make_image(1, 1, {Rgb(3, 1.5F, -2)})};
    materials.add(Rgb(7));
    materials.add(Rgb(1)).image = 0;
    const SurfaceColors colors = materials.colors();
    EXPECT_LT(kLargestReflectance, 1);
    EXPECT_EQ(colors.reflectance_at(0, {0, 0}, 0), Rgb(kLargestReflectance));
    EXPECT_EQ(colors.reflectance_at(1, {0, 0}, 0), Rgb(kLargestReflectance, kLargestReflectance, 0));
}

TEST(SurfaceColor, negative_and_infinite_factors_are_zero_with_a_message) {
    for (const float bad : {-1.0F, kInfinity, std::numeric_limits<float>::quiet_NaN()}) {
        Materials materials;
        materials.add(Rgb(bad, 1, 1), Rgb(1, bad, 1));
        const SurfaceColors colors = materials.colors();
        EXPECT_EQ(colors.reflectance_at(0, {0, 0}, 0), Rgb(0));
        EXPECT_EQ(colors.emission_at(0, {0, 0}, 0), Rgb(0));
        EXPECT_FALSE(colors.emits(0));
        EXPECT_EQ(materials.messages.all().size(), 2U);
    }
}

TEST(SurfaceColor, an_image_that_does_not_exist_is_white_with_a_message) {
    Materials materials;
    materials.add(Rgb(0.5F)).image = 3;
    const SurfaceColors colors = materials.colors();
    EXPECT_EQ(colors.reflectance_at(0, {0, 0}, 0), Rgb(0.5F));
    EXPECT_FALSE(colors.is_textured(0));
    EXPECT_EQ(materials.messages.all().size(), 1U);
}

TEST(SurfaceColor, a_mapping_that_is_not_finite_leaves_the_factor_with_a_message) {
    Materials materials;
    materials.description.images = {make_image(1, 1, {Rgb(0.25F)})};
    ColorInput& input = materials.add(Rgb(0.5F));
    input.image = 0;
    input.uv_map[2] = kInfinity;
    const SurfaceColors colors = materials.colors();
    EXPECT_EQ(colors.reflectance_at(0, {0, 0}, 0), Rgb(0.5F));
    EXPECT_EQ(materials.messages.all().size(), 1U);
}

TEST(SurfaceColor, factor_scales_the_image_at_the_mapped_coordinates) {
    Materials materials;
    materials.description.images = {make_image(2, 2, {Rgb(0.125F), Rgb(0.25F), Rgb(0.5F), Rgb(1.5F)})};
    ColorInput& input = materials.add(Rgb(0));
    input.factor = Rgb(0.5F, 0.25F, 0);
    input.image = 0;
    const float swap_and_shift[6] = {0, 1, 0.5F, 1, 0, 0};  // u' = v + 0.5, v' = u
    std::copy(std::begin(swap_and_shift), std::end(swap_and_shift), input.uv_map);
    const SurfaceColors colors = materials.colors();
    EXPECT_TRUE(colors.is_textured(0));
    EXPECT_EQ(colors.reflectance_at(0, {0.25F, 0.25F}, 0), Rgb(0.125F, 0.0625F, 0));    // (0.75, 0.25): lower right
    EXPECT_EQ(colors.reflectance_at(0, {0.25F, 0.75F}, 0), Rgb(0.0625F, 0.03125F, 0));  // (1.25, 0.25): lower left
    EXPECT_EQ(colors.reflectance_at(0, {0.75F, 0.75F}, 0), Rgb(0.25F, 0.125F, 0));      // (1.25, 0.75): upper left
}

TEST(SurfaceColor, the_width_is_stretched_like_the_coordinates) {
    std::vector<Rgb> checkers;
    for (int index = 0; index < 32 * 32; ++index) {
        checkers.emplace_back((index % 32 + index / 32) % 2 ? 0.9F : 0.1F);
    }
    Materials materials;
    materials.description.images = {make_image(32, 32, checkers)};
    ColorInput& input = materials.add(Rgb(1));
    input.image = 0;
    input.uv_map[0] = input.uv_map[4] = 100;
    const SurfaceColors colors = materials.colors();
    EXPECT_NEAR(colors.reflectance_at(0, {0.5F / 3200, 0.5F / 3200}, 0).g, 0.1, 1e-3);
    EXPECT_NEAR(colors.reflectance_at(0, {0.5F / 3200, 0.5F / 3200}, 0.002F).g, 0.5, 1e-3);
}

TEST(SurfaceColor, the_mean_over_a_triangle_is_that_of_many_samples) {
    std::vector<Rgb> noise;
    for (std::uint64_t index = 0; index < 64 * 64; ++index) {
        noise.emplace_back(0.9F * unit_float(hash64(index)), static_cast<float>(index % 64) / 64.0F, 0.3F);
    }
    Materials materials;
    materials.description.images = {make_image(64, 64, noise)};
    materials.add(Rgb(1)).image = 0;
    materials.description.materials[0].emission = {Rgb(10), 0, {1, 0, 0, 0, 1, 0}};
    const SurfaceColors colors = materials.colors();
    for (const float size : {1.0F, 0.3F, 0.05F, 0.015F, 0.006F}) {
        const Vec2 a = size * kCorners[0], b = size * kCorners[1], c = size * kCorners[2];
        Vec3d truth(0);
        constexpr int kSide = 300;
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                const Vec3 w =
                    square_to_triangle((static_cast<float>(x) + 0.5F) / kSide, (static_cast<float>(y) + 0.5F) / kSide);
                truth += Vec3d(colors.reflectance_at(0, w.x * a + w.y * b + w.z * c, 0)) / double(kSide * kSide);
            }
        }
        const Rgb mean = colors.mean_reflectance(0, a, b, c);
        const Rgb emitted = colors.mean_emission(0, a, b, c);
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_NEAR(mean[channel], truth[channel], 0.03) << size;
            EXPECT_NEAR(emitted[channel], 10 * truth[channel], 0.3) << size;
        }
        EXPECT_EQ(colors.mean_reflectance(0, a, b, c), mean);
    }
}

TEST(SurfaceColor, the_mean_over_a_point_is_its_colour) {
    Materials materials;
    materials.description.images = {make_image(2, 1, {Rgb(0.25F), Rgb(0.75F)})};
    materials.add(Rgb(1)).image = 0;
    const SurfaceColors colors = materials.colors();
    const Vec2 point(0.25F, 0.5F);
    EXPECT_NEAR(colors.mean_reflectance(0, point, point, point).g, 0.25, 1e-3);
}

TEST(SurfaceColor, textured_emission_counts_and_black_one_does_not) {
    Materials materials;
    materials.description.images = {make_image(1, 1, {Rgb(2)})};
    materials.add(Rgb(0.5F));
    materials.description.materials[0].emission.image = 0;  // factor 0
    materials.add(Rgb(0.5F), Rgb(0, 0, 3));
    materials.description.materials[1].emission.image = 0;
    const SurfaceColors colors = materials.colors();
    EXPECT_FALSE(colors.emits(0));
    EXPECT_FALSE(colors.is_textured(0));
    EXPECT_TRUE(colors.emits(1));
    EXPECT_TRUE(colors.is_textured(1));
    EXPECT_EQ(colors.emission_at(1, {0, 0}, 0), Rgb(0, 0, 6));
}

}  // namespace
}  // namespace gg
