#include "image/texel_codec.h"

#include <gtest/gtest.h>

#include <limits>

namespace gg {
namespace {

TEST(TexelCodec, srgb_decoding_is_the_standards_formula) {
    EXPECT_EQ(srgb_to_linear(0), 0);
    EXPECT_FLOAT_EQ(srgb_to_linear(1), 1);
    EXPECT_NEAR(srgb_to_linear(0.5F), 0.2140411, 1e-6);  // ((0.5 + 0.055) / 1.055)^2.4
    EXPECT_NEAR(srgb_to_linear(0.04F), 0.04 / 12.92, 1e-8);
    EXPECT_EQ(srgb_to_linear(-0.5F), -srgb_to_linear(0.5F));
    for (int byte = 0; byte < 256; ++byte) {
        EXPECT_EQ(byte_decoding(true)[byte], srgb_to_linear(static_cast<float>(byte) / 255.0F));
        EXPECT_EQ(byte_decoding(false)[byte], static_cast<float>(byte) / 255.0F);
    }
}

TEST(TexelCodec, bytes_survive_decoding_and_encoding) {
    for (const bool srgb : {false, true}) {
        for (int byte = 0; byte < 256; ++byte) {
            EXPECT_EQ(encode_byte(byte_decoding(srgb)[byte], srgb), byte);
        }
    }
}

TEST(TexelCodec, encoding_finds_the_nearest_byte_and_clamps) {
    for (const bool srgb : {false, true}) {
        for (int step = 0; step <= 5000; ++step) {
            const float encoded = static_cast<float>(step) / 5000.0F;
            const int byte = encode_byte(srgb ? srgb_to_linear(encoded) : encoded, srgb);
            EXPECT_NEAR(static_cast<float>(byte), encoded * 255.0F, 0.501F);
        }
        EXPECT_EQ(encode_byte(-1, srgb), 0);
        EXPECT_EQ(encode_byte(7, srgb), 255);
        EXPECT_EQ(encode_byte(std::numeric_limits<float>::quiet_NaN(), srgb), 0);
    }
}

TEST(TexelCodec, half_floats_survive_the_round_trip) {
    for (std::uint32_t half = 0; half <= 0x7bff; ++half) {  // all finite ones
        const auto bits = static_cast<std::uint16_t>(half);
        EXPECT_EQ(float_to_half(half_to_float(bits)), bits);
    }
    EXPECT_EQ(half_to_float(0x3c00), 1);
    EXPECT_EQ(half_to_float(0xc000), -2);
    EXPECT_EQ(half_to_float(0x7bff), kLargestHalf);
    EXPECT_EQ(half_to_float(0x0001), 0x1p-24F);  // least denormal
}

TEST(TexelCodec, halves_round_to_nearest_clamp_and_drop_nan) {
    EXPECT_EQ(half_to_float(float_to_half(1.0F + 0x1p-12F)), 1);  // a quarter of a step
    EXPECT_EQ(half_to_float(float_to_half(1.0F + 3 * 0x1p-12F)), 1 + 0x1p-10F);
    EXPECT_EQ(half_to_float(float_to_half(1e9F)), kLargestHalf);
    EXPECT_EQ(half_to_float(float_to_half(-std::numeric_limits<float>::infinity())), -kLargestHalf);
    EXPECT_EQ(float_to_half(std::numeric_limits<float>::quiet_NaN()), 0);
    for (float value = 1e-4F; value < 6e4F; value *= 1.37F) {
        EXPECT_NEAR(half_to_float(float_to_half(value)) / value, 1, 0x1p-11);
    }
}

}  // namespace
}  // namespace gg
