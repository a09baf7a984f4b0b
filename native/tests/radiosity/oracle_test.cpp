// What the oracle lets pass.
#include "radiosity/oracle.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gg::test {
namespace {

// An equal step in the square root of irradiance up to twice the white; above it an equal one: what is bright lights
// all that is around it.
TEST(Oracle, differences_that_are_allowed_grow_up_to_twice_the_white) {
    const RefineSettings settings{0.02F, {4, 1}};
    EXPECT_FLOAT_EQ(allowed_difference(4, settings), 0.08F);
    EXPECT_FLOAT_EQ(allowed_difference(1, settings), 0.04F);
    EXPECT_FLOAT_EQ(allowed_difference(0.01F, settings), allowed_difference(0, settings));
    EXPECT_FLOAT_EQ(allowed_difference(8, settings), 0.08F * std::sqrt(2.0F));
    EXPECT_FLOAT_EQ(allowed_difference(64, settings), allowed_difference(8, settings));
}

}  // namespace
}  // namespace gg::test
