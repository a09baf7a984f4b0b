#include "core/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace gg {
namespace {

TEST(Random, hash_is_a_function_of_its_input_alone_and_spreads_neighbours) {
    std::set<std::uint64_t> seen;
    int flipped_bits = 0;
    for (std::uint64_t x = 0; x < 1000; ++x) {
        EXPECT_EQ(hash64(x), hash64(x));
        seen.insert(hash64(x));
        flipped_bits += __builtin_popcountll(hash64(x) ^ hash64(x + 1));
    }
    EXPECT_EQ(seen.size(), 1000U);
    EXPECT_NEAR(flipped_bits / 1000.0, 32, 1);
    EXPECT_NE(hash64(1, 2), hash64(2, 1));
}

TEST(Random, unit_float_lies_in_0_to_1_and_never_is_1) {
    EXPECT_EQ(unit_float(0), 0);
    EXPECT_LT(unit_float(~0ULL), 1);
    EXPECT_GT(unit_float(~0ULL), 0.9999F);
}

TEST(Random, sequence_values_lie_in_0_to_1_and_repeat_for_equal_seeds) {
    const Sequence4 sequence(7), again(7), other(8);
    bool differs = false;
    for (std::uint32_t index = 0; index < 5000; ++index) {
        for (int dimension = 0; dimension < 4; ++dimension) {
            const float value = sequence(index, dimension);
            EXPECT_GE(value, 0);
            EXPECT_LT(value, 1);
            EXPECT_EQ(value, again(index, dimension));
            differs |= value != other(index, dimension);
        }
    }
    EXPECT_TRUE(differs);
}

// Radius of the largest hole that `count` points of two dimensions leave in the unit torus, times sqrt(count).
// Independent random points leave 1.4 to 1.5.
double hole_size(const Sequence4& sequence, std::uint32_t count, int first, int second) {
    constexpr int kProbes = 64;  // a side
    double largest = 0;
    for (int probe = 0; probe < kProbes * kProbes; ++probe) {
        double nearest = 1;
        for (std::uint32_t index = 0; index < count; ++index) {
            const double x = std::abs(sequence(index, first) - (probe % kProbes) / double(kProbes));
            const double y = std::abs(sequence(index, second) - (probe / kProbes) / double(kProbes));
            nearest = std::min(nearest, std::hypot(std::min(x, 1 - x), std::min(y, 1 - y)));
        }
        largest = std::max(largest, nearest);
    }
    return largest * std::sqrt(count);
}

TEST(Random, sequence_pairs_01_and_23_leave_no_holes_for_any_prefix) {
    const Sequence4 sequence(3);
    for (const std::uint32_t count : {8U, 16U, 45U, 100U, 256U}) {
        EXPECT_LT(hole_size(sequence, count, 0, 1), 1.1) << count;
        EXPECT_LT(hole_size(sequence, count, 2, 3), 1.1) << count;
    }
}

TEST(Random, disk_map_keeps_area) {
    // A quarter of the square's points lie within half the radius.
    int inner = 0;
    constexpr int kSide = 200;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const Vec2 point =
                square_to_disk((static_cast<float>(x) + 0.5F) / kSide, (static_cast<float>(y) + 0.5F) / kSide);
            const float radius = std::hypot(point.x, point.y);
            EXPECT_LE(radius, 1);
            inner += radius < 0.5F ? 1 : 0;
        }
    }
    EXPECT_NEAR(inner / double(kSide * kSide), 0.25, 0.005);
}

TEST(Random, disk_to_square_inverts_the_disk_map) {
    constexpr int kSide = 40;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const Vec2 place{(static_cast<float>(x) + 0.5F) / kSide, (static_cast<float>(y) + 0.25F) / kSide};
            const Vec2 back = disk_to_square(square_to_disk(place.x, place.y));
            EXPECT_NEAR(back.x, place.x, 1e-6F);
            EXPECT_NEAR(back.y, place.y, 1e-6F);
        }
    }
    EXPECT_EQ(disk_to_square({0, 0}), Vec2(0.5F));
}

TEST(Random, triangle_weights_are_positive_sum_to_one_and_average_to_a_third) {
    Vec3d mean(0);
    constexpr int kSide = 100;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const Vec3 weights =
                square_to_triangle((static_cast<float>(x) + 0.5F) / kSide, (static_cast<float>(y) + 0.5F) / kSide);
            EXPECT_GE(std::min({weights.x, weights.y, weights.z}), -1e-6F);
            EXPECT_NEAR(weights.x + weights.y + weights.z, 1, 1e-6);
            mean += Vec3d(weights) / double(kSide * kSide);
        }
    }
    for (int corner = 0; corner < 3; ++corner) {
        EXPECT_NEAR(mean[corner], 1.0 / 3, 1e-3);
    }
}

TEST(Random, cosine_hemisphere_has_its_mean_and_unit_length) {
    constexpr int kSide = 128;
    Vec3 sum(0.0F);
    for (int i = 0; i < kSide * kSide; ++i) {
        const Vec3 d = square_to_cosine_hemisphere((static_cast<float>(i % kSide) + 0.5F) / kSide,
                                                   (static_cast<float>(i / kSide) + 0.5F) / kSide);
        EXPECT_NEAR(length(d), 1, 1e-6F);
        EXPECT_GE(d.z, 0);
        sum += d;
    }
    // The mean cosine under a density of cosine over pi is 2/3.
    EXPECT_LT(length(sum / static_cast<float>(kSide * kSide) - Vec3(0, 0, 2.0F / 3)), 1e-3F);
}

}  // namespace
}  // namespace gg
