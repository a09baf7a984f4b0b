#include "image/display_transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gg::test {
namespace {

Rgb encoded(const DisplaySettings& settings, Rgb pixel) {
    DisplayTransform(settings).encode(std::span(&pixel, 1));
    return pixel;
}

TEST(DisplayTransform, without_configuration_is_srgb) {
    const Rgb code = encoded({}, {0.5F, 0.002F, 1});  // IEC 61966-2-1
    EXPECT_NEAR(code.r, 0.735357F, 1e-5F);
    EXPECT_NEAR(code.g, 12.92F * 0.002F, 1e-6F);
    EXPECT_NEAR(code.b, 1, 1e-6F);
    EXPECT_TRUE(DisplayTransform({}).failure().empty());
}

TEST(DisplayTransform, exposure_is_in_stops_and_gamma_bends_codes) {
    DisplaySettings settings;
    settings.exposure = 1;
    EXPECT_NEAR(encoded(settings, Rgb(0.25F)).g, 0.735357F, 1e-5F);
    settings.gamma = 2;
    EXPECT_NEAR(encoded(settings, Rgb(0.25F)).g, std::sqrt(0.735357F), 1e-5F);
}

TEST(DisplayTransform, light_of_srgb_is_what_it_was) {
    Rgb pixel(0.001F, 0.2F, 3);
    DisplayTransform({}).show(std::span(&pixel, 1));
    EXPECT_NEAR(pixel.r, 0.001F, 1e-6F);
    EXPECT_NEAR(pixel.g, 0.2F, 1e-5F);
    EXPECT_NEAR(pixel.b, 1, 1e-6F);
}

TEST(DisplayTransform, what_is_not_finite_is_black) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(encoded({}, {nan, 1, 1}), Rgb(0.0F));
    EXPECT_EQ(encoded({}, {1, kInfinity, 1}), Rgb(0.0F));
    EXPECT_EQ(encoded({}, Rgb(-1.0F)), Rgb(0.0F));
}

TEST(DisplayTransform, says_why_a_configuration_is_not_used) {
    DisplaySettings settings;
    settings.config = "/nowhere/config.ocio";
    const DisplayTransform transform(settings);
    EXPECT_NE(transform.failure(), "");
    Rgb pixel(0.5F);
    transform.encode(std::span(&pixel, 1));
    EXPECT_NEAR(pixel.g, 0.735357F, 1e-5F);
}

}  // namespace
}  // namespace gg::test
