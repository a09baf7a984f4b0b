#include "transport/fast_angle.h"

#include <gtest/gtest.h>

namespace gg {
namespace {

TEST(FastAngle, is_the_angle_all_around) {
    for (int i = 0; i <= 100000; ++i) {
        const double angle = std::acos(-1.0) * i / 100000;
        const auto sine = static_cast<float>(std::sin(angle)), cosine = static_cast<float>(std::cos(angle));
        const double exact = std::atan2(static_cast<double>(std::max(sine, 0.0F)), static_cast<double>(cosine));
        const auto fast = static_cast<double>(fast_angle(std::max(sine, 0.0F), cosine));
        EXPECT_NEAR(fast, exact, 3e-7 * exact) << angle;
        const Wide lanes = fast_angle(Wide(3 * std::max(sine, 0.0F)), Wide(3 * cosine));
        EXPECT_NEAR(static_cast<double>(lanes[2]), exact, 4e-7 * exact) << angle;
    }
}

}  // namespace
}  // namespace gg
