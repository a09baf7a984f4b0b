#include "perception/tvi.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gg::test {
namespace {

// Published data, to their digits.
TEST(Tvi, has_known_values) {
    EXPECT_NEAR(just_noticeable(0.1F), 0.0403F, 5e-5F);
    EXPECT_NEAR(just_noticeable(1), 0.3913F, 5e-4F);
    EXPECT_NEAR(just_noticeable(10), 1.0719F, 1e-3F);
    EXPECT_NEAR(just_noticeable(50), 3.088F, 3e-3F);
    EXPECT_NEAR(just_noticeable(100), 5.559F, 5e-3F);
    EXPECT_NEAR(just_noticeable(1e-4F), std::pow(10.0F, -2.86F), 1e-6F);
}

// By day a share of the luminance is seen.
TEST(Tvi, follows_weber_where_it_is_bright) {
    EXPECT_NEAR(just_noticeable(1000) / 1000, 0.0556F, 1e-4F);
    EXPECT_NEAR(just_noticeable(20000) / just_noticeable(10000), 2, 1e-4F);
}

TEST(Tvi, rises_and_its_pieces_join) {
    float before = 0;
    for (float x = -6; x < 5; x += 0.001F) {
        const float now = just_noticeable(std::pow(10.0F, x));
        if (before > 0) {
            EXPECT_GT(now / before, 0.96F) << x;  // published pieces join within 3 %
            EXPECT_LT(now / before, 1.04F) << x;
        }
        before = now;
    }
}

TEST(Tvi, of_black_is_the_least) {
    EXPECT_EQ(just_noticeable(0), just_noticeable(1e-5F));
    EXPECT_EQ(just_noticeable(-1), just_noticeable(0));
}

}  // namespace
}  // namespace gg::test
