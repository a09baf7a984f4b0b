#include "perception/luminance_pyramid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/control.h"

namespace gg::test {
namespace {

std::vector<float> row_of(const LuminancePyramid& pyramid, int level, std::uint32_t row) {
    std::vector<float> values;
    pyramid.stretched_row(level, row, values);
    return values;
}

TEST(LuminancePyramid, keeps_what_is_even) {
    const Control control;
    for (const auto& [width, height] : {std::pair(1U, 1U), {3U, 5U}, {64U, 33U}}) {
        const LuminancePyramid pyramid(width, height, std::vector<float>(width * height, 3.0F), 8, control);
        for (int level = 0; level < 8; ++level) {
            const auto row = row_of(pyramid, level, height - 1);
            ASSERT_EQ(row.size(), width);
            for (const float value : row) {
                EXPECT_NEAR(value, 3, 1e-5F);
            }
        }
    }
}

// Every level is as wide in the picture as twice the one before: a ramp stays a ramp, in its place.
TEST(LuminancePyramid, keeps_ramps_in_their_place) {
    const Control control;
    constexpr std::uint32_t kSide = 513;
    std::vector<float> values(kSide * kSide);
    for (std::uint32_t y = 0; y < kSide; ++y) {
        for (std::uint32_t x = 0; x < kSide; ++x) {
            values[y * kSide + x] = static_cast<float>(x) + 3 * static_cast<float>(y);
        }
    }
    const LuminancePyramid pyramid(kSide, kSide, values, 6, control);
    for (int level = 0; level < 6; ++level) {
        for (const std::uint32_t y : {200U, 251U, 300U}) {
            const auto row = row_of(pyramid, level, y);
            for (std::uint32_t x = 150; x < 350; ++x) {
                EXPECT_NEAR(row[x], values[y * kSide + x], 0.01F) << level;
            }
        }
    }
}

// One bright pixel becomes the weights themselves [Burt and Adelson 1983].
TEST(LuminancePyramid, has_known_weights) {
    const Control control;
    constexpr std::uint32_t kSide = 65, kMiddle = 32;
    std::vector<float> values(kSide * kSide, 0.0F);
    values[kMiddle * kSide + kMiddle] = 1;
    const LuminancePyramid pyramid(kSide, kSide, values, 2, control);
    const auto row = row_of(pyramid, 1, kMiddle);
    EXPECT_NEAR(row[kMiddle], 0.16F, 1e-6F);
    EXPECT_NEAR(row[kMiddle + 2], 0.4F * 0.05F, 1e-6F);
    EXPECT_NEAR(row[kMiddle + 1], 0.5F * (0.16F + 0.4F * 0.05F), 1e-6F);
    EXPECT_EQ(row[kMiddle + 4], 0);
}

// The weights' variance is 0.9 of a level's samples, and these are twice as far apart from level to level.
TEST(LuminancePyramid, widens_by_two_from_level_to_level) {
    const Control control;
    constexpr std::uint32_t kSide = 257, kMiddle = 128;
    constexpr double kVariance = 16;
    std::vector<float> values(kSide * kSide);
    for (std::uint32_t y = 0; y < kSide; ++y) {
        for (std::uint32_t x = 0; x < kSide; ++x) {
            const double dx = static_cast<double>(x) - kMiddle, dy = static_cast<double>(y) - kMiddle;
            values[y * kSide + x] = static_cast<float>(std::exp(-(dx * dx + dy * dy) / (2 * kVariance)));
        }
    }
    const LuminancePyramid pyramid(kSide, kSide, values, 4, control);
    double expected = kVariance;
    for (int level = 0; level < 4; ++level) {
        double sum = 0, spread = 0;
        const std::uint32_t step = 1U << level;
        for (std::uint32_t y = 0; y < kSide; y += step) {
            const auto row = row_of(pyramid, level, y);
            for (std::uint32_t x = 0; x < kSide; x += step) {
                const double from = static_cast<double>(x) - kMiddle;
                sum += static_cast<double>(row[x]);
                spread += static_cast<double>(row[x]) * from * from;
            }
        }
        EXPECT_NEAR(sum * step * step, 2 * 3.14159265 * kVariance, 0.01) << level;
        EXPECT_NEAR(spread / sum, expected, 2e-3 * expected) << level;
        expected += 0.9 * step * step;
    }
}

}  // namespace
}  // namespace gg::test
