// The float versions against the double ones, over nine orders of magnitude of form factors.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "random_scenes.h"
#include "transport/form_factor.h"

namespace gg {
namespace {

struct Case {
    std::array<Vec3, 3> triangle;  // relative to x = 0
    Vec3 n;
};

// Triangles of all shapes, `nearest` to `farthest` times their size away; every other one touches the horizon. The last
// step of every number is float arithmetic: GCC 12's vectoriser drops the rounding of double -> float -> double.
Case random_case(test::Random& random, int trial, double nearest, double farthest) {
    const double distance = std::exp(random.uniform(std::log(nearest), std::log(farthest)));
    const Vec3 center = static_cast<float>(distance) * Vec3(random.direction());
    const auto around = random.polygon(Vec3d(0), 1, 3);
    Case c{{center + Vec3(around[0]), center + Vec3(around[1]), center + Vec3(around[2])}, Vec3(random.direction())};
    if (trial % 2 == 0) {
        const auto share = static_cast<float>(random.uniform());
        const Vec3 target = normalize_or_zero(c.triangle[0] + share * (c.triangle[1] - c.triangle[0]));
        c.n -= dot(c.n, target) * target;
    }
    c.n = normalize_or_zero(c.n);
    return c;
}

bool near_plane(const Case& c) {
    const Vec3d a(c.triangle[0]);
    const Vec3d area = glm::cross(Vec3d(c.triangle[1]) - a, Vec3d(c.triangle[2]) - a);
    double largest = 0;
    for (const Vec3 v : c.triangle) {
        largest = std::max(largest, static_cast<double>(length(v)));
    }
    return std::abs(glm::dot(area, a)) < 1e-4 * largest * glm::length(area);
}

TEST(form_factor_accuracy, float_holds_what_the_header_states) {
    test::Random random(4);
    double worst = 0;
    int tested = 0;
    for (int trial = 0; trial < 200000; ++trial) {
        const Case c = random_case(random, trial, 0.3, 1e4);
        if (near_plane(c)) {
            continue;
        }
        ++tested;
        const auto& t = c.triangle;
        const std::array<Vec3d, 3> exact{Vec3d(t[0]), Vec3d(t[1]), Vec3d(t[2])};
        const double truth = point_to_triangle(Vec3d(0), Vec3d(c.n), exact[0], exact[1], exact[2]);
        const double allowed = std::max(truth, 1e-3);
        worst = std::max(worst, std::abs(point_to_triangle(Vec3(0), c.n, t[0], t[1], t[2]) - truth) / allowed);
        worst = std::max(worst, std::abs(point_to_polygon(Vec3(0), c.n, t) - truth) / allowed);
        const Vec3d phi = vector_form_factor(Vec3d(0), exact);
        const double phi_error = glm::length(Vec3d(vector_form_factor(Vec3(0), t)) - phi);
        worst = std::max(worst, phi_error / std::max(glm::length(phi), 1e-3));
    }
    EXPECT_GT(tested, 150000);
    EXPECT_LE(worst, kFormFactorAccuracy);
}

// Where the contour sum would have lost them all. The floor keeps grazing triangles from dividing by nothing.
TEST(form_factor_accuracy, far_triangles_keep_their_digits) {
    test::Random random(5);
    double worst = 0;
    for (int trial = 0; trial < 50000; ++trial) {
        const Case c = random_case(random, trial, 100, 1e4);
        if (near_plane(c)) {
            continue;
        }
        const auto& t = c.triangle;
        const double truth = point_to_triangle(Vec3d(0), Vec3d(c.n), Vec3d(t[0]), Vec3d(t[1]), Vec3d(t[2]));
        const double floor = 0.01 / static_cast<double>(length_squared(t[0]));
        worst = std::max(worst,
                         std::abs(point_to_triangle(Vec3(0), c.n, t[0], t[1], t[2]) - truth) / std::max(truth, floor));
    }
    EXPECT_LE(worst, 2e-5);
}

}  // namespace
}  // namespace gg
