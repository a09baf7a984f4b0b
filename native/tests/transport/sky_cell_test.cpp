#include "transport/sky_cell.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace gg {
namespace {

// The cells of one level, all over the sphere.
std::vector<SkyCell> cells_of(int level) {
    const auto roots = sky_roots();
    std::vector<SkyCell> cells(roots.begin(), roots.end());
    for (int i = 0; i < level; ++i) {
        std::vector<SkyCell> next;
        for (const SkyCell cell : cells) {
            const auto parts = children(cell);
            next.insert(next.end(), parts.begin(), parts.end());
        }
        cells = next;
    }
    return cells;
}

TEST(sky_cell, cells_partition_the_sphere) {
    for (int level = 0; level <= 4; ++level) {
        double sum = 0;
        for (const SkyCell cell : cells_of(level)) {
            EXPECT_EQ(cell.level, level);
            sum += static_cast<double>(cell_solid_angle(cell));
        }
        EXPECT_NEAR(sum, 4 * static_cast<double>(kPi), 1e-5);
    }
}

TEST(sky_cell, children_sum_to_their_parent) {
    for (const SkyCell cell : cells_of(3)) {
        float sum = 0;
        for (const SkyCell child : children(cell)) {
            sum += cell_solid_angle(child);
        }
        EXPECT_EQ(sum, cell_solid_angle(cell));
    }
}

TEST(sky_cell, children_cover_the_quarters_of_their_parent) {
    for (const SkyCell cell : cells_of(2)) {
        const auto parts = children(cell);
        for (int part = 0; part < 4; ++part) {
            for (const Vec2 p : {Vec2(0.25F, 0.125F), Vec2(0.75F, 0.5F)}) {
                const Vec2 in_parent{0.5F * (p.x + static_cast<float>(part & 1)),
                                     0.5F * (p.y + static_cast<float>(part >> 1))};
                EXPECT_LT(
                    length(cell_direction(parts[part], p.x, p.y) - cell_direction(cell, in_parent.x, in_parent.y)),
                    1e-6F);
            }
        }
    }
}

// The solid angle of the cell's outline, by the boundary's geometry alone: fine fans of spherical triangles.
TEST(sky_cell, solid_angle_is_that_of_the_directions) {
    constexpr int kSteps = 64;
    for (const SkyCell cell : cells_of(3)) {
        double sum = 0;
        for (int i = 0; i < kSteps; ++i) {
            for (int j = 0; j < kSteps; ++j) {
                const auto at = [&](int a, int b) {
                    return Vec3d(
                        cell_direction(cell, static_cast<float>(i + a) / kSteps, static_cast<float>(j + b) / kSteps));
                };
                sum += 0.5 * glm::length(glm::cross(at(1, 1) - at(0, 0), at(0, 1) - at(1, 0)));
            }
        }
        EXPECT_NEAR(sum, static_cast<double>(cell_solid_angle(cell)), 1e-3 * sum);
    }
}

TEST(sky_cell, directions_are_unit_and_stay_on_their_side_of_the_horizon) {
    for (const SkyCell cell : cells_of(4)) {
        for (const Vec2 p : {Vec2(0, 0), Vec2(1, 0), Vec2(0.5F, 0.5F), Vec2(1, 1)}) {
            const Vec3 direction = cell_direction(cell, p.x, p.y);
            EXPECT_NEAR(length(direction), 1, 1e-6F);
            EXPECT_GE(cell.face == 0 ? direction.z : -direction.z, 0);
        }
    }
}

TEST(sky_cell, sphere_samples_have_the_moments_of_the_uniform_sphere) {
    constexpr int kSteps = 256;
    Vec3d mean(0);
    Vec3d squares(0);
    double mixed = 0;
    for (int i = 0; i < kSteps; ++i) {
        for (int j = 0; j < kSteps; ++j) {
            const Vec3d d(
                square_to_sphere((static_cast<float>(i) + 0.5F) / kSteps, (static_cast<float>(j) + 0.5F) / kSteps));
            mean += d;
            squares += d * d;
            mixed += d.x * d.y;
        }
    }
    const double count = kSteps * kSteps;
    EXPECT_LT(glm::length(mean / count), 1e-5);
    EXPECT_LT(glm::length(squares / count - Vec3d(1.0 / 3)), 1e-4);
    EXPECT_NEAR(mixed / count, 0, 1e-5);
}

TEST(sky_cell, a_direction_is_in_the_cell_that_it_came_from) {
    for (const SkyCell cell : cells_of(3)) {
        for (const Vec2 place : {Vec2(0.02F, 0.9F), Vec2(0.5F, 0.5F), Vec2(0.97F, 0.04F)}) {
            const SkyCell finest = finest_cell_at(cell_direction(cell, place.x, place.y));
            for (const SkyCell other : cells_of(3)) {
                EXPECT_EQ(contains(other, finest), other == cell);
            }
        }
    }
}

TEST(sky_cell, a_cell_contains_its_descendants_and_no_ancestor) {
    const SkyCell cell{2, 1, 3, 0};
    const SkyCell part = children(children(cell)[1])[2];
    EXPECT_TRUE(contains(cell, cell));
    EXPECT_TRUE(contains(cell, part));
    EXPECT_FALSE(contains(part, cell));
    EXPECT_FALSE(contains({2, 0, 3, 0}, part));
}

}  // namespace
}  // namespace gg
