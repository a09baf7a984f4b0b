#include "transport/penumbra.h"

#include <gtest/gtest.h>

namespace gg {
namespace {

TEST(penumbra, width_follows_similar_triangles) {
    EXPECT_NEAR(penumbra_width(0.5F, 3, 1), 0.25F, 1e-6F);
    EXPECT_NEAR(penumbra_width(0.5F, 3, 0.1F), 0.017241379F, 1e-7F);
}

TEST(penumbra, contact_is_sharp_and_an_occluder_on_the_sender_blurs_without_bound) {
    EXPECT_EQ(penumbra_width(0.5F, 3, 0), 0);
    EXPECT_EQ(penumbra_width(0.5F, 3, 3), kInfinity);
    EXPECT_EQ(penumbra_width(0.5F, 3, 4), kInfinity);
}

}  // namespace
}  // namespace gg
