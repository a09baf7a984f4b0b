// What the oracle lets pass.
#include "radiosity/oracle.h"

#include <gtest/gtest.h>

namespace gg::test {
namespace {

// An equal step in the square root of irradiance up to the white; above it an equal one: what is bright lights all that
// is around it.
TEST(Oracle, differences_that_are_allowed_grow_up_to_the_white) {
    const RefineSettings settings{0.02F, {4, 1}};
    EXPECT_FLOAT_EQ(allowed_difference(4, settings), 0.08F);
    EXPECT_FLOAT_EQ(allowed_difference(1, settings), 0.04F);
    EXPECT_FLOAT_EQ(allowed_difference(0.01F, settings), allowed_difference(0, settings));
    EXPECT_FLOAT_EQ(allowed_difference(64, settings), 0.08F);
}

}  // namespace
}  // namespace gg::test
