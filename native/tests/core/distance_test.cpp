#include "core/distance.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace gg {
namespace {

const std::array<Vec3, 3> kTriangle{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 3, 0)};

TEST(distance_to_triangle, known_values) {
    EXPECT_FLOAT_EQ(distance_to_triangle({1, 1, 2}, kTriangle), 2);          // above
    EXPECT_FLOAT_EQ(distance_to_triangle({1, 1, -2}, kTriangle), 2);         // below
    EXPECT_FLOAT_EQ(distance_to_triangle({-3, -4, 0}, kTriangle), 5);        // beyond a corner
    EXPECT_FLOAT_EQ(distance_to_triangle({2, -3, 4}, kTriangle), 5);         // beyond an edge
    EXPECT_FLOAT_EQ(distance_to_triangle({4, 3, 0}, kTriangle), 12.0F / 5);  // beyond the long edge
    EXPECT_EQ(distance_to_triangle({1, 1, 0}, kTriangle), 0);
}

TEST(distance_to_triangle, of_a_line_and_a_point) {
    EXPECT_FLOAT_EQ(distance_to_triangle({1, 2, 0}, {Vec3(0), Vec3(3, 0, 0), Vec3(1, 0, 0)}), 2);
    EXPECT_FLOAT_EQ(distance_to_triangle({0, 0, 2}, {Vec3(0), Vec3(0), Vec3(0)}), 2);
}

TEST(distance_to_triangle, no_point_of_it_is_nearer) {
    const Sequence4 sequence(3);
    for (std::uint32_t i = 0; i < 50; ++i) {
        const Vec3 p = 8.0F * Vec3(sequence(i, 0), sequence(i, 1), sequence(i, 2)) - 2.0F;
        const float distance = distance_to_triangle(p, kTriangle);
        float least = kInfinity;
        for (std::uint32_t k = 0; k < 4000; ++k) {
            const Vec3 w = square_to_triangle(sequence(k, 0), sequence(k, 3));
            least = std::min(least, length(p - w.x * kTriangle[0] - w.y * kTriangle[1] - w.z * kTriangle[2]));
        }
        EXPECT_LE(distance, least + 1e-5F);
        EXPECT_NEAR(distance, least, 0.15F);
    }
}

}  // namespace
}  // namespace gg
