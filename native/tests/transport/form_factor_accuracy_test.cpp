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

// Triangles of all shapes, 0.3 to 10,000 times their size away; every other one crosses the horizon if it can.
Case random_case(test::Random& random, int trial) {
    const double distance = std::pow(10.0, random.uniform(-0.5, 4));
    const auto corners = random.polygon(distance * random.direction(), 1, 3);
    Vec3d n = random.direction();
    if (trial % 2 == 0) {
        const Vec3d target = glm::normalize(corners[0] + random.uniform() * (corners[1] - corners[0]));
        n = glm::normalize(n - glm::dot(n, target) * target);
    }
    return {{Vec3(corners[0]), Vec3(corners[1]), Vec3(corners[2])}, Vec3(n)};
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
        const Case c = random_case(random, trial);
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
    RecordProperty("worst", std::to_string(worst));
    printf("worst %g tested %d\n", worst, tested);
    EXPECT_GT(tested, 150000);
    EXPECT_LE(worst, kFormFactorAccuracy);
}

TEST(form_factor_accuracy, relative_error_of_far_polygons) {
    test::Random random(4);
    for (double lo = -0.5; lo < 4; lo += 0.5) {
        double worst = 0, sum = 0; int n = 0;
        for (int trial = 0; trial < 40000; ++trial) {
            const double distance = std::pow(10.0, random.uniform(lo, lo + .5));
            const auto corners = random.polygon(distance * random.direction(), 1, 3);
            Case c{{Vec3(corners[0]), Vec3(corners[1]), Vec3(corners[2])}, Vec3(random.direction())};
            if (near_plane(c)) continue;
            const auto& t = c.triangle;
            const double truth = point_to_triangle(Vec3d(0), Vec3d(c.n), Vec3d(t[0]), Vec3d(t[1]), Vec3d(t[2]));
            const double e = std::abs(point_to_triangle(Vec3(0), c.n, t[0], t[1], t[2]) - truth)/std::max(truth, .01/(distance*distance));
            worst = std::max(worst, e); sum += e; ++n;
        }
        printf("%g: worst rel %g mean %g\n", lo, worst, sum / n);
    }
}

}  // namespace
}  // namespace gg
