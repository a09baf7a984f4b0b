// Small errors in sum.
#include "gather/error_budget.h"

#include <gtest/gtest.h>

namespace gg {
namespace {

TEST(ErrorBudget, few_small_errors_stay) {
    EXPECT_TRUE(beyond_budget(std::vector<float>(6, 0.8F), 1).empty());
    EXPECT_TRUE(beyond_budget({}, 1).empty());
}

// 200 of an eighth: the sum is 25, 6 may stay; the squares would allow all.
TEST(ErrorBudget, the_sum_of_many_is_kept) {
    EXPECT_EQ(beyond_budget(std::vector<float>(200, 0.125F), 1).size(), 152U);
}

// Five of 0.9: the sum is 4.5, their squares 4.05.
TEST(ErrorBudget, the_squares_of_large_ones_are_kept) {
    EXPECT_EQ(beyond_budget(std::vector<float>(5, 0.9F), 1).size(), 1U);
}

TEST(ErrorBudget, the_largest_go_first_and_all_but_zeros_at_no_tolerance) {
    const std::vector<float> errors{0.5F, 0, 3, 1, 0.5F};
    EXPECT_EQ(beyond_budget(errors, 0.5F), (std::vector<std::size_t>{2, 3}));
    EXPECT_EQ(beyond_budget(errors, 0), (std::vector<std::size_t>{2, 3, 0, 4}));
}

}  // namespace
}  // namespace gg
