#include "image/view_curves.h"

#include <gtest/gtest.h>

#include "image/display_transform.h"

namespace gg::test {
namespace {

ViewCurves identity() {
    ViewCurves curves;
    for (ViewCurves::Channel& channel : curves.channels) {
        channel.values = {0, 1};
        channel.slope_below = channel.slope_above = 1;
    }
    return curves;
}

TEST(ViewCurves, that_are_straight_change_nothing) {
    for (const float x : {-3.0F, 0.0F, 0.25F, 1.0F, 40.0F}) {
        EXPECT_EQ(identity()(Rgb(x)), Rgb(x));
    }
}

TEST(ViewCurves, are_linear_between_their_values_and_beyond_them) {
    ViewCurves curves = identity();
    curves.lower = -1;
    curves.channels[0].values = {0, 4, 6};
    curves.channels[0].slope_below = 2;
    curves.channels[0].slope_above = -0.5F;
    const auto red = [&](float x) { return curves(Rgb(x, 0, 0)).r; };
    EXPECT_FLOAT_EQ(red(-1), 0);
    EXPECT_FLOAT_EQ(red(-0.75F), 1);
    EXPECT_FLOAT_EQ(red(0.5F), 5);
    EXPECT_FLOAT_EQ(red(1), 6);
    EXPECT_FLOAT_EQ(red(-2), -2);
    EXPECT_FLOAT_EQ(red(3), 5);
}

TEST(ViewCurves, begin_at_black_and_end_at_white) {
    ViewCurves curves = identity();
    curves.channels[1].black = 0.5F;
    curves.channels[1].white = 2.5F;
    EXPECT_FLOAT_EQ(curves(Rgb(1.5F)).g, 0.5F);
    curves.channels[1].white = 0.5F;  // no range is taken for a small one
    EXPECT_NEAR(curves(Rgb(1.5F)).g, 1e5F, 1e3F);
}

// Before the exposure.
TEST(ViewCurves, are_the_first_that_a_display_transform_does) {
    DisplaySettings settings;
    settings.exposure = 1;
    settings.curves = identity();
    settings.curves->channels[0].values = {0, 0.5F};
    Rgb pixel(1.0F, 0.25F, 0), expected(0.5F, 0.25F, 0);
    DisplayTransform(settings).encode(std::span(&pixel, 1));
    settings.curves.reset();
    DisplayTransform(settings).encode(std::span(&expected, 1));
    EXPECT_EQ(pixel, expected);
}

}  // namespace
}  // namespace gg::test
