#include "image/mip_pyramid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/random.h"

namespace gg {
namespace {

RawImage make_bytes(std::uint32_t width, std::uint32_t height) {
    RawImage image;
    image.header = {width, height, true};
    for (std::uint32_t index = 0; index < 3 * width * height; ++index) {
        image.bytes.push_back(static_cast<std::uint8_t>(hash64(index) >> 56));
    }
    return image;
}

Vec3d linear_mean(const RawImage& image, bool srgb) {
    Vec3d sum(0);
    for (std::size_t index = 0; index < image.bytes.size(); ++index) {
        sum[static_cast<int>(index % 3)] += byte_decoding(srgb)[image.bytes[index]];
    }
    return sum / double(image.header.width * image.header.height);
}

TEST(MipPyramid, levels_halve_down_to_one_texel) {
    const MipPyramid pyramid = make_mip_pyramid(make_bytes(13, 4), true, 0);
    const std::uint32_t expected[][2] = {{13, 4}, {6, 2}, {3, 1}, {1, 1}};
    ASSERT_EQ(pyramid.levels.size(), 4U);
    for (std::size_t level = 0; level < 4; ++level) {
        EXPECT_EQ(pyramid.levels[level].width, expected[level][0]);
        EXPECT_EQ(pyramid.levels[level].height, expected[level][1]);
    }
    EXPECT_EQ(pyramid.memory_bytes(), 3U * (52 + 12 + 3 + 1));
    EXPECT_EQ(pyramid.memory_bytes(), pyramid_bytes({13, 4, true}, 0));
}

TEST(MipPyramid, every_level_has_the_linear_mean_of_the_image_for_any_size) {
    for (const bool srgb : {false, true}) {
        for (const auto& [width, height] : {std::pair{64U, 64U}, {63U, 33U}, {5U, 1U}, {1U, 7U}, {100U, 3U}}) {
            RawImage image = make_bytes(width, height);
            const Vec3d mean = linear_mean(image, srgb);
            const MipPyramid pyramid = make_mip_pyramid(std::move(image), srgb, 0);
            const Rgb top = pyramid.texel(pyramid.levels.back(), 0, 0);
            for (int channel = 0; channel < 3; ++channel) {
                EXPECT_NEAR(top[channel], mean[channel], 0.006) << width << "x" << height;  // half a byte of rounding
            }
        }
    }
}

TEST(MipPyramid, a_float_image_keeps_its_mean_to_half_precision) {
    RawImage image;
    image.header = {31, 17, false};
    double mean = 0;
    for (std::uint32_t index = 0; index < 3 * 31 * 17; ++index) {
        image.floats.push_back(std::exp2(8 * unit_float(hash64(index))));
        mean += index % 3 == 1 ? image.floats.back() / (31 * 17) : 0;
    }
    const MipPyramid pyramid = make_mip_pyramid(std::move(image), false, 0);
    EXPECT_NEAR(pyramid.texel(pyramid.levels.back(), 0, 0).g / mean, 1, 1e-3);
}

TEST(MipPyramid, a_constant_image_is_constant_in_all_levels) {
    RawImage image;
    image.header = {37, 21, true};
    image.bytes.assign(3 * 37 * 21, 99);
    const MipPyramid pyramid = make_mip_pyramid(std::move(image), true, 0);
    for (const std::uint8_t byte : pyramid.bytes) {
        ASSERT_EQ(byte, 99);
    }
}

TEST(MipPyramid, srgb_floats_are_decoded_and_broken_ones_are_zero) {
    RawImage image;
    image.header = {2, 1, false};
    image.floats = {0.5F, 1, 0, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 0.25F};
    const MipPyramid pyramid = make_mip_pyramid(std::move(image), true, 0);
    EXPECT_NEAR(pyramid.texel(pyramid.levels[0], 0, 0).r, srgb_to_linear(0.5F), 1e-4);
    EXPECT_EQ(pyramid.texel(pyramid.levels[0], 1, 0).r, 0);
    EXPECT_EQ(pyramid.texel(pyramid.levels[0], 1, 0).g, 0);
}

TEST(MipPyramid, dropping_levels_leaves_the_coarser_ones_as_they_were) {
    const MipPyramid whole = make_mip_pyramid(make_bytes(16, 8), true, 0);
    const MipPyramid less = make_mip_pyramid(make_bytes(16, 8), true, 2);
    ASSERT_EQ(less.levels.size(), whole.levels.size() - 2);
    EXPECT_EQ(less.memory_bytes(), pyramid_bytes({16, 8, true}, 2));
    for (std::size_t level = 0; level < less.levels.size(); ++level) {
        for (std::uint32_t x = 0; x < less.levels[level].width; ++x) {
            EXPECT_EQ(less.texel(less.levels[level], x, 0), whole.texel(whole.levels[level + 2], x, 0));
        }
    }
    EXPECT_EQ(make_mip_pyramid(make_bytes(16, 8), true, 99).levels.size(), 1U);
}

}  // namespace
}  // namespace gg
