#include "gather/direction_table.h"

#include <gtest/gtest.h>

#include <set>

namespace gg::test {
namespace {

TEST(DirectionTable, cells_and_indices_agree) {
    std::set<std::uint32_t> found;
    for (std::uint32_t c = 0; c < kTableCells; ++c) {
        EXPECT_EQ(table_index(table_cell(c)), c);
        for (const SkyCell child : children(table_cell(c))) {
            EXPECT_EQ(table_index(child), c);
        }
        found.insert(c);
    }
    EXPECT_EQ(found.size(), kTableCells);
}

TEST(DirectionTable, one_of_two_partners_stands_for_both) {
    EXPECT_EQ(one_of_partners(TableCellSet().set()).count(), kTableCells / 2);
    for (std::uint32_t c = 0; c < kTableCells; ++c) {
        const SkyCell cell = table_cell(c), other = table_cell(table_partner(c));
        EXPECT_EQ(table_partner(table_partner(c)), c);
        EXPECT_EQ(std::abs(cell.i - other.i) + std::abs(cell.j - other.j), 1);
        EXPECT_EQ(cell.face, other.face);
        const TableCellSet of_one = one_of_partners(TableCellSet().set(c));
        EXPECT_EQ(of_one.count(), 1U);
        EXPECT_TRUE(of_one[c] || of_one[table_partner(c)]);
        EXPECT_EQ(of_one, one_of_partners(TableCellSet().set(table_partner(c))));
        const bool right = cell.i % 8 != 7;
        EXPECT_FALSE(right && one_of_partners(TableCellSet().set())[c] && one_of_partners(TableCellSet().set())[c + 1]);
    }
}

// The integral of max(0, n.d) over the sphere is pi.
TEST(DirectionTable, even_light_is_pi_on_every_normal) {
    DirectionTable table;
    for (std::uint32_t c = 0; c < kTableCells; ++c) {
        table.add(c, kTableSolidAngle * Rgb(1, 2, 3));
    }
    for (const Vec3 n : {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(1, 0, 0), Vec3(0.6F, 0, 0.8F), Vec3(0.48F, -0.6F, 0.64F),
                         Vec3(-0.36F, 0.48F, -0.8F)}) {
        const Rgb light = light_of(table, TableCosines(n));
        EXPECT_NEAR(light.x, kPi, 0.01F * kPi) << n.x << ' ' << n.y << ' ' << n.z;
        EXPECT_NEAR(light.z, 3 * light.x, 1e-4F);
    }
}

TEST(DirectionTable, cosines_are_means_over_cells) {
    const Vec3 n = normalize_or_zero({0.3F, -0.5F, 0.2F});
    const TableCosines cosines(n);
    constexpr int kSide = 32;
    for (std::uint32_t c = 0; c < kTableCells; ++c) {
        float mean = 0;
        for (int k = 0; k < kSide * kSide; ++k) {
            const Vec3 d = cell_direction(table_cell(c), (static_cast<float>(k % kSide) + 0.5F) / kSide,
                                          (static_cast<float>(k / kSide) + 0.5F) / kSide);
            mean += std::max(0.0F, dot(n, d)) / (kSide * kSide);
        }
        EXPECT_NEAR(cosines.of[c], mean, 0.03F) << c;
    }
}

// No step where a cell sinks below the horizon of a normal that turns.
TEST(DirectionTable, cosines_are_continuous_in_the_normal) {
    TableCosines before(Vec3(1, 0, 0));
    constexpr int kSteps = 2000;
    for (int i = 1; i <= kSteps; ++i) {
        const float angle = 2 * kPi * static_cast<float>(i) / kSteps;
        const TableCosines now(Vec3(std::cos(angle), 0.6F * std::sin(angle), 0.8F * std::sin(angle)));
        for (std::uint32_t c = 0; c < kTableCells; ++c) {
            ASSERT_NEAR(now.of[c], before.of[c], 0.005F);
        }
        before = now;
    }
}

}  // namespace
}  // namespace gg::test
