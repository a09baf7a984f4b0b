// Laws between whole areas; point_to_polygon integrated over the receiver by the oracle.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "oracles/form_factor_oracle.h"

namespace gg {
namespace {

using oracle::area_to_polygon;
using oracle::coaxial_disks;
using oracle::parallel_rectangles;
using oracle::perpendicular_rectangles;
using Quad = std::array<Vec3d, 4>;

constexpr double kTolerance = 1e-6;

Quad quad(Vec3d corner, Vec3d u, Vec3d v) {
    return {corner, corner + u, corner + u + v, corner + v};
}

TEST(form_factor_areas, parallel_rectangles_have_the_textbook_values) {
    struct Case {
        double a, b, c, value;
    };
    for (const Case& k : {Case{1, 1, 1, 0.199824895698387}, Case{2, 1, 1, 0.285875384850715},
                          Case{1, 1, 0.1, 0.826994522397257}, Case{1, 1, 10, 0.003162056838754}}) {
        EXPECT_NEAR(parallel_rectangles(k.a, k.b, k.c), k.value, 1e-12);
        const double measured =
            area_to_polygon({0, 0, 0}, {k.a, 0, 0}, {0, k.b, 0}, quad({0, 0, k.c}, {k.a, 0, 0}, {0, k.b, 0}));
        EXPECT_NEAR(measured, k.value, kTolerance);
    }
}

TEST(form_factor_areas, perpendicular_rectangles_have_the_textbook_values) {
    EXPECT_NEAR(perpendicular_rectangles(1, 1, 1), 0.200043776075403, 1e-12);
    EXPECT_NEAR(perpendicular_rectangles(1, 2, 1), 0.232852602795362, 1e-12);
    EXPECT_NEAR(perpendicular_rectangles(2, 1, 1), 0.116426301397681, 1e-12);
    for (const double height : {1.0, 2.0}) {
        // Floor [0, 1]^2, wall in x = 0.
        const double measured =
            area_to_polygon({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, quad({0, 0, 0}, {0, 1, 0}, {0, 0, height}));
        EXPECT_NEAR(measured, perpendicular_rectangles(1, height, 1), kTolerance);
    }
    const double back = area_to_polygon({0, 0, 0}, {0, 1, 0}, {0, 0, 2}, quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
    EXPECT_NEAR(back, 0.116426301397681, kTolerance);
}

TEST(form_factor_areas, faces_of_a_box_sum_to_one) {
    struct Case {
        Vec3d size;
        double opposite, side_x, side_y;  // side_x shares the edge along x
    };
    for (const Case& k : {Case{{3, 4, 5}, 0.116827664251250, 0.190187685866452, 0.251398482007924},
                          Case{{1, 1, 1}, 0.199824895698387, 0.200043776075403, 0.200043776075403}}) {
        const Vec3d x{k.size.x, 0, 0};
        const Vec3d y{0, k.size.y, 0};
        const Vec3d z{0, 0, k.size.z};
        const auto from_floor = [&](const Quad& face) { return area_to_polygon({0, 0, 0}, x, y, face); };
        const double opposite = from_floor(quad(z, x, y));
        const double front = from_floor(quad({0, 0, 0}, x, z));
        const double rear = from_floor(quad(y, x, z));
        const double left = from_floor(quad({0, 0, 0}, y, z));
        const double right = from_floor(quad(x, y, z));
        EXPECT_NEAR(opposite, k.opposite, kTolerance);
        EXPECT_NEAR(front, k.side_x, kTolerance);
        EXPECT_NEAR(rear, k.side_x, kTolerance);
        EXPECT_NEAR(left, k.side_y, kTolerance);
        EXPECT_NEAR(right, k.side_y, kTolerance);
        EXPECT_NEAR(opposite + front + rear + left + right, 1, kTolerance);
    }
}

TEST(form_factor_areas, coaxial_disks_have_the_textbook_values) {
    EXPECT_NEAR(coaxial_disks(1, 1, 1), 0.381966011250105, 1e-12);
    EXPECT_NEAR(coaxial_disks(0.5, 1, 1), 0.468871125850725, 1e-12);
    EXPECT_NEAR(coaxial_disks(1, 0.5, 1), 0.117217781462681, 1e-12);
    EXPECT_NEAR(oracle::disk_to_polygon(1, oracle::disk_polygon(1, 1, 256)), 0.381966011250105, kTolerance);
    EXPECT_NEAR(oracle::disk_to_polygon(0.5, oracle::disk_polygon(1, 1, 256)), 0.468871125850725, kTolerance);
    EXPECT_NEAR(oracle::disk_to_polygon(1, oracle::disk_polygon(0.5, 1, 256)), 0.117217781462681, kTolerance);
}

// A1 F12 = A2 F21, for two skew parallelograms, each wholly in front of the other.
TEST(form_factor_areas, areas_times_form_factors_are_reciprocal) {
    const Vec3d corner1{0, 0, 0};
    const Vec3d u1{2, 0.3, 0};
    const Vec3d v1{0.5, 1, 0.4};
    const Vec3d corner2{1.5, 2, 1.5};
    const Vec3d u2{1.8, 0.3, 0};
    const Vec3d v2{0.2, -0.5, 1.5};
    const double area1 = glm::length(glm::cross(u1, v1));
    const double area2 = glm::length(glm::cross(u2, v2));
    const double f12 = area_to_polygon(corner1, u1, v1, quad(corner2, u2, v2));
    const double f21 = area_to_polygon(corner2, u2, v2, quad(corner1, u1, v1));
    EXPECT_GT(f12, 0.01);
    EXPECT_NEAR(area1 * f12, area2 * f21, 1e-9);
}

}  // namespace
}  // namespace gg
