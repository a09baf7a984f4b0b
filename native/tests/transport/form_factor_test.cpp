#include "transport/form_factor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

#include "oracles/form_factor_oracle.h"
#include "random_scenes.h"

namespace gg {
namespace {

constexpr double kExact = 1e-12;
const Vec3d kOrigin{0, 0, 0};
const Vec3d kUp{0, 0, 1};

// Axis-parallel rectangle in the plane z.
std::vector<Vec3d> rectangle(double x0, double y0, double x1, double y1, double z) {
    return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

TEST(form_factor, point_to_square_has_the_textbook_values) {
    EXPECT_NEAR(point_to_polygon(kOrigin, kUp, rectangle(-.5, -.5, .5, .5, 1)), 0.239456470460774, kExact);
    EXPECT_NEAR(point_to_polygon(kOrigin, kUp, rectangle(-1, -1, 1, 1, 1)), 0.554126423979572, kExact);
    EXPECT_NEAR(point_to_polygon(kOrigin, kUp, rectangle(0, 0, 1, 1, 1)), 0.138531605994893, kExact);
    EXPECT_NEAR(point_to_polygon(kOrigin, Vec3d(1, 0, 0), rectangle(0, 0, 1, 1, 1)), 0.055734197002552, kExact);
}

TEST(form_factor, horizon_hides_half_of_a_square) {
    EXPECT_NEAR(point_to_polygon(kOrigin, Vec3d(1, 0, 0), rectangle(-1, -1, 1, 1, 1)), 0.111468394005107, kExact);
    EXPECT_EQ(point_to_polygon(kOrigin, Vec3d(0, 0, -1), rectangle(-1, -1, 1, 1, 1)), 0);
}

TEST(form_factor, point_to_triangle_has_the_textbook_value) {
    const Vec3d a{0, 0, 1};
    const Vec3d b{1, 0, 1};
    const Vec3d c{0, 1, 1};
    EXPECT_NEAR(point_to_triangle(kOrigin, kUp, a, b, c), 0.096225044864938, kExact);
    EXPECT_NEAR(point_to_triangle(kOrigin, kUp, a, c, b), 0.096225044864938, kExact);
    EXPECT_NEAR(point_to_polygon(kOrigin, kUp, std::array{c, b, a}), 0.096225044864938, kExact);
}

// Lanes from next to the triangle to far away, the horizon cutting some of them.
TEST(form_factor, points_at_a_time_have_what_each_has_alone) {
    test::Random random(12);
    int whole = 0, cut = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const auto corners = random.polygon(Vec3d(0.0), 1, 3);
        const std::array<Vec3, 3> triangle{Vec3(corners[0]), Vec3(corners[1]), Vec3(corners[2])};
        WideVec3 x, n;
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            x.set(lane, Vec3(std::pow(10.0, random.uniform(-1, 2)) * random.direction()));
            n.set(lane, Vec3(random.direction()));
        }
        WideMask clipped;
        const Wide found = points_to_triangle(x, n, triangle, clipped);
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const float alone = point_to_triangle(x.lane(lane), n.lane(lane), triangle[0], triangle[1], triangle[2]);
            if (clipped[lane]) {
                EXPECT_EQ(static_cast<float>(found[lane]), 0);
                ++cut;
            } else {
                EXPECT_NEAR(found[lane], alone, 2 * kFormFactorAccuracy * std::max(alone, 1e-3F));
                whole += alone > 0 ? 1 : 0;
            }
        }
    }
    EXPECT_GT(whole, 3000);
    EXPECT_GT(cut, 500);
}

TEST(form_factor, solid_angles_have_the_textbook_values) {
    const auto square = [](double half) {
        const auto q = rectangle(-half, -half, half, half, 1);
        return triangle_solid_angle(q[0], q[1], q[2]) + triangle_solid_angle(q[0], q[2], q[3]);
    };
    EXPECT_NEAR(square(0.5), 0.805431683161323, kExact);
    EXPECT_NEAR(square(1), 2.094395102393195, kExact);
    EXPECT_NEAR(triangle_solid_angle<Vec3d>({0, 0, 1}, {1, 0, 1}, {0, 1, 1}), 0.339836909454122, kExact);
    EXPECT_NEAR(triangle_solid_angle<Vec3d>({2, 0, 0}, {0, 0, 3}, {0, 1, 0}), std::numbers::pi / 2, kExact);
}

TEST(form_factor, sphere_has_the_textbook_values) {
    EXPECT_NEAR(point_to_sphere(1.0, 4.0), 0.0625, kExact);
    EXPECT_NEAR(point_to_sphere(0.3, 2.0), 0.078715, 1e-6);
    EXPECT_NEAR(point_to_sphere(0.0, 2.0), 0.028834, 1e-6);
    EXPECT_NEAR(point_to_sphere(-0.3, 2.0), 0.003715, 1e-6);
    EXPECT_NEAR(point_to_sphere(0.1, 4.0), 0.007268, 1e-6);
    EXPECT_EQ(point_to_sphere(-0.6, 2.0), 0);
    EXPECT_EQ(point_to_sphere(-1.0, 1.0), 0);
    EXPECT_NEAR(point_to_sphere(0.4, 1.0), 0.7, kExact);
    EXPECT_NEAR(point_to_sphere(1.0, 0.5), 1, kExact);
    EXPECT_NEAR(point_to_sphere(0.1F, 4.0F), 0.007268F, 1e-6F);
}

TEST(form_factor, sphere_is_continuous_where_the_horizon_touches_it) {
    for (const double h : {1.001, 2.0, 50.0}) {
        EXPECT_NEAR(point_to_sphere((1 - 1e-9) / h, h), point_to_sphere((1 + 1e-9) / h, h), 1e-7 / h);
        EXPECT_NEAR(point_to_sphere((-1 + 1e-9) / h, h), 0, 1e-7 / h);
    }
}

// The mean of the clamped cosine over all normals is 1/4, times the solid angle over pi.
TEST(form_factor, sphere_averages_to_a_quarter_over_all_normals) {
    for (const double h : {1.0, 1.5, 6.0}) {
        const int steps = 20000;
        double mean = 0;
        for (int i = 0; i < steps; ++i) {
            mean += point_to_sphere(-1 + (i + 0.5) * 2 / steps, h) / steps;
        }
        const double solid_angle = 2 * std::numbers::pi * (1 - std::sqrt(1 - 1 / (h * h)));
        EXPECT_NEAR(mean, solid_angle / (4 * std::numbers::pi), 1e-6);
    }
}

TEST(form_factor, disk_kernel_is_exact_for_a_facing_disk_and_bounded) {
    const double radius = 0.7;
    const double area = std::numbers::pi * radius * radius;
    EXPECT_NEAR(disk_kernel(1.0, 1.0, 4.0, area), radius * radius / (radius * radius + 4), kExact);
    EXPECT_EQ(disk_kernel(1.0, 1.0, 0.0, area), 1);
    EXPECT_EQ(disk_kernel(-0.5, -0.5, 1.0, area), 0);
    EXPECT_EQ(disk_kernel(0.5, 0.5, 0.0, 0.0), 0);
}

TEST(form_factor, cap_is_solid_angle_times_cosine_over_pi) {
    EXPECT_NEAR(cap_form_factor(0.5, 0.01), 0.005 / std::numbers::pi, kExact);
    EXPECT_EQ(cap_form_factor(-0.5F, 0.01F), 0);
}

TEST(form_factor, agrees_with_counted_rays) {
    test::Random random(1);
    for (int trial = 0; trial < 40; ++trial) {
        const auto polygon =
            random.polygon(random.uniform(0.3, 2) * random.direction(), random.uniform(0.5, 2), 3 + trial % 5);
        const Vec3d n = random.direction();
        const double counted = oracle::counted_form_factor(kOrigin, n, polygon, 40000);
        EXPECT_NEAR(point_to_polygon(kOrigin, n, polygon), counted, 2e-3) << trial;
        if (polygon.size() == 3) {
            EXPECT_NEAR(point_to_triangle(kOrigin, n, polygon[0], polygon[1], polygon[2]), counted, 2e-3) << trial;
        }
    }
}

TEST(form_factor, polygon_is_the_sum_of_its_triangles_in_either_winding) {
    test::Random random(2);
    for (int trial = 0; trial < 300; ++trial) {
        const Vec3d x = random.direction();
        const double distance = std::pow(10.0, random.uniform(-1, 4));
        auto polygon = random.polygon(x + distance * random.direction(), random.uniform(0.1, 1), 3 + trial % 4);
        const Vec3d n = random.direction();
        const double whole = point_to_polygon(x, n, polygon);
        double sum = 0;
        for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
            sum += point_to_triangle(x, n, polygon[0], polygon[i], polygon[i + 1]);
        }
        EXPECT_NEAR(sum, whole, 1e-8 * whole + 1e-13) << trial;
        std::reverse(polygon.begin(), polygon.end());
        EXPECT_NEAR(point_to_polygon(x, n, polygon), whole, 1e-8 * whole + 1e-13) << trial;
    }
}

TEST(form_factor, vector_points_to_the_polygon_and_projects_to_the_form_factor) {
    test::Random random(3);
    int above = 0;
    for (int trial = 0; trial < 300; ++trial) {
        const Vec3d x = random.direction();
        const double distance = std::pow(10.0, random.uniform(-1, 4));
        auto polygon = random.polygon(x + distance * random.direction(), random.uniform(0.1, 1), 3 + trial % 4);
        if (trial % 2 == 0) {
            std::reverse(polygon.begin(), polygon.end());
        }
        const Vec3d phi = vector_form_factor(x, polygon);
        const Vec3d plane = glm::cross(polygon[1] - polygon[0], polygon[2] - polygon[0]);
        EXPECT_GT(glm::dot(phi, plane) * glm::dot(polygon[0] - x, plane), 0) << trial;
        EXPECT_LE(glm::length(phi), 1);
        const Vec3d n = random.direction();
        if (std::all_of(polygon.begin(), polygon.end(), [&](Vec3d v) { return glm::dot(n, v - x) > 0; })) {
            ++above;
            const double expected = point_to_polygon(x, n, polygon);
            EXPECT_NEAR(glm::dot(phi, n), expected, 1e-8 * expected + 1e-13) << trial;
        }
    }
    EXPECT_GT(above, 50);
}

TEST(form_factor, vector_of_a_concave_polygon_is_that_of_its_parts) {
    const Vec3d x{0.3, -0.2, -0.5};
    const std::vector<Vec3d> arrow{{0, 0, 1}, {2, 1, 1}, {0, 2, 1}, {0.5, 1, 1}};
    const Vec3d parts = vector_form_factor(x, std::array{arrow[0], arrow[1], arrow[3]}) +
                        vector_form_factor(x, std::array{arrow[1], arrow[2], arrow[3]});
    EXPECT_LT(glm::length(vector_form_factor(x, arrow) - parts), kExact);
    const Vec3d far_away{300, 200, -5000};
    const Vec3d far_parts = vector_form_factor(far_away, std::array{arrow[0], arrow[1], arrow[3]}) +
                            vector_form_factor(far_away, std::array{arrow[1], arrow[2], arrow[3]});
    EXPECT_LT(glm::length(vector_form_factor(far_away, arrow) - far_parts), 1e-7 * glm::length(far_parts));
}

// In the plane, on an edge, on a corner, inside: zero, since a plane sees nothing of itself.
TEST(form_factor, points_of_the_polygons_plane_get_zero_and_no_nan) {
    const Vec3 a{0.3F, 0.1F, 0.7F};
    const Vec3 b{1.3F, 0.4F, 0.2F};
    const Vec3 c{0.2F, 1.1F, 0.9F};
    const std::array polygon{a, b, c};
    const std::array points{a,
                            b,
                            c,
                            0.5F * (a + b),
                            a + 0.3F * (c - a),
                            (a + b + c) / 3.0F,
                            2.0F * a - b,
                            a + 7.0F * (b - a) + 3.0F * (c - a)};
    const Vec3 plane = normalize_or_zero(cross(b - a, c - a));
    for (const Vec3 x : points) {
        for (const Vec3 n : {plane, -plane, Vec3(1, 0, 0), normalize_or_zero(b - a), Vec3(0, 0, -1)}) {
            EXPECT_EQ(point_to_triangle(x, n, a, b, c), 0);
            EXPECT_EQ(point_to_polygon(x, n, polygon), 0);
        }
        EXPECT_EQ(vector_form_factor(x, polygon), Vec3(0));
        EXPECT_TRUE(std::isfinite(triangle_solid_angle(a - x, b - x, c - x)));
    }
}

TEST(form_factor, just_above_a_polygon_it_fills_the_hemisphere) {
    const auto square = rectangle(-1, -1, 1, 1, 0);
    EXPECT_NEAR(point_to_polygon(Vec3d(0.2, 0.1, -1e-7), kUp, square), 1, 1e-6);
    const std::array<Vec3, 4> same{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}};
    EXPECT_NEAR(point_to_polygon(Vec3(0.2F, 0.1F, -1e-4F), Vec3(0, 0, 1), same), 1, 1e-3);
}

TEST(form_factor, repeated_corners_change_nothing) {
    const Vec3 a{0, 0, 1};
    const Vec3 b{1, 0, 1};
    const Vec3 c{0, 1, 1};
    const Vec3 n{0, 0, 1};
    EXPECT_NEAR(point_to_polygon(Vec3(0), n, std::array{a, a, b, b, c}), 0.096225045F, 1e-7F);
    EXPECT_NEAR(vector_form_factor(Vec3(0), std::array{a, b, b, c, a}).z, 0.096225045F, 1e-7F);
}

TEST(form_factor, degenerate_polygons_count_as_zero) {
    const Vec3 p{1, 2, 3};
    const Vec3 q{2, 2, 5};
    const Vec3 n{0, 0, 1};
    EXPECT_EQ(point_to_triangle(Vec3(0), n, p, p, p), 0);
    EXPECT_EQ(point_to_triangle(Vec3(0), n, p, q, p), 0);
    EXPECT_EQ(point_to_triangle(Vec3(0), n, p, q, 2.0F * q - p), 0);
    EXPECT_EQ(point_to_polygon(Vec3(0), n, std::array{p, q}), 0);
    EXPECT_EQ(point_to_polygon(Vec3(0), n, {}), 0);
    EXPECT_EQ(vector_form_factor(Vec3(0), std::array{p, q, p, q}), Vec3(0));
    EXPECT_EQ(triangle_solid_angle(p, p, q), 0);
    EXPECT_EQ(triangle_solid_angle(Vec3(0), p, q), 0);
}

}  // namespace
}  // namespace gg
