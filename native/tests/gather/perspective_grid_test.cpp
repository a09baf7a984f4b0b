// Grids of what is seen: weights, matching faces, depth laws.
#include "gather/perspective_grid.h"

#include <gtest/gtest.h>

#include <map>

#include "core/random.h"

namespace gg {
namespace {

PixelCamera camera(CameraType type = CameraType::kPerspective) {
    CameraDescription description;
    description.type = type;
    const float window[4] = {-0.7F, 0.7F, -0.35F, 0.35F};
    std::copy(std::begin(window), std::end(window), description.window);
    description.clip_end = 1000;
    return {description, 700, 350};
}

Vec3 random_point(const Sequence4& sequence, std::uint32_t i) {
    const float depth = 1 + 9 * sequence(i, 2);
    return {depth * (1.4F * sequence(i, 0) - 0.7F), depth * (0.7F * sequence(i, 1) - 0.35F), -depth};
}

// Corner k of the unit cube.
Vec3 corner(int k) {
    return {static_cast<float>(k & 1), static_cast<float>(k >> 1 & 1), static_cast<float>(k >> 2)};
}

TEST(PlaceInCube, weights_are_those_of_the_point_in_its_tetrahedron) {
    const Sequence4 sequence(1);
    for (std::uint32_t i = 0; i < 20000; ++i) {
        const Vec3 p(sequence(i, 0), sequence(i, 1), sequence(i, 2));
        for (const bool odd : {false, true}) {
            const CubePlace place = place_in_cube(p, odd);
            Vec3 back(0.0F);
            float sum = 0;
            for (int k = 0; k < 4; ++k) {
                ASSERT_GE(place.weights[k], 0);
                back += place.weights[k] * corner(place.corners[k]);
                sum += place.weights[k];
            }
            ASSERT_NEAR(sum, 1, 1e-6F);
            ASSERT_LT(length(back - p), 1e-6F);
        }
    }
}

// The same value at a face from either cube, when corners have any values: x = 1 of an even cube is x = 0 of an odd
// one.
TEST(PlaceInCube, faces_of_neighbours_match) {
    const Sequence4 sequence(2);
    const auto value = [](Vec3 vertex) {
        return unit_float(hash64(std::lround(vertex.x * 9 + vertex.y * 3 + vertex.z)));
    };
    for (std::uint32_t i = 0; i < 20000; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 here(sequence(i, 0), sequence(i, 1), sequence(i, 2)), there = here;
            here[axis] = 1;
            there[axis] = 0;
            Vec3 step(0.0F);
            step[axis] = 1;
            float a = 0, b = 0;
            const CubePlace even = place_in_cube(here, false), odd = place_in_cube(there, true);
            for (int k = 0; k < 4; ++k) {
                a += even.weights[k] * value(corner(even.corners[k]));
                b += odd.weights[k] * value(corner(odd.corners[k]) + step);
            }
            ASSERT_NEAR(a, b, 1e-5F) << axis;
        }
    }
}

// Interpolating a value of every vertex along a walk: no step is larger than its length allows.
TEST(PerspectiveGrid, interpolation_is_continuous_and_every_point_has_a_place) {
    const PerspectiveGrid grid(camera(), 700, 350, {20, 1, 10, DepthLaw::kLogarithmic});
    const auto at = [&](Vec3 p) {
        const GridPlace place = grid.place(p);
        float sum = 0, weights = 0;
        for (int k = 0; k < 4; ++k) {
            EXPECT_LT(place.vertices[k], grid.vertex_count());
            sum += place.weights[k] * unit_float(hash64(place.vertices[k]));
            weights += place.weights[k];
        }
        EXPECT_NEAR(weights, 1, 1e-5F);
        return sum;
    };
    const Sequence4 sequence(3);
    for (std::uint32_t walk = 0; walk < 8; ++walk) {
        const Vec3 from = random_point(sequence, 2 * walk), to = random_point(sequence, 2 * walk + 1);
        constexpr int kSteps = 10000;
        float before = at(from);
        for (int i = 1; i <= kSteps; ++i) {
            const float now = at(glm::mix(from, to, static_cast<float>(i) / kSteps));
            ASSERT_LT(std::abs(now - before), 0.05F) << walk << " " << i;
            before = now;
        }
    }
    EXPECT_NEAR(at({0, 0, -100}), at({0, 0, -1000}), 1e-5F);  // beyond the grid: its border
}

TEST(PerspectiveGrid, cells_are_about_as_deep_as_wide) {
    const PerspectiveGrid grid(camera(), 700, 350, {20, 1, 10, DepthLaw::kLogarithmic});
    // 35 x 18 cells and a margin of one; ln(10) / (20 pixels of 0.002 m at 1 m).
    EXPECT_NEAR(static_cast<float>(grid.vertex_count()), 38.0F * 21.0F * 59.0F, 38.0F * 21.0F);
}

TEST(PerspectiveGrid, reciprocal_law_makes_even_steps_of_one_over_z) {
    const PerspectiveGrid grid(camera(), 700, 350, {20, 1, 10, DepthLaw::kReciprocal});
    const PerspectiveGrid linear(camera(CameraType::kOrthographic), 700, 350, {20, 1, 10, DepthLaw::kLinear});
    // Where half of the range is.
    const auto layer = [](const PerspectiveGrid& g, Vec3 p) {
        const GridPlace place = g.place(p);
        float sum = 0;
        for (int k = 0; k < 4; ++k) {
            sum += place.weights[k] * std::floor(static_cast<float>(place.vertices[k]) / (38.0F * 21.0F));
        }
        return sum;
    };
    const float last = layer(grid, {0, 0, -10}), last_linear = layer(linear, {0, 0, -10});
    EXPECT_NEAR(layer(grid, {0, 0, -2 / 1.1F}) / last, 0.5F, 1e-3F);
    EXPECT_NEAR(layer(linear, {0, 0, -5.5F}) / last_linear, 0.5F, 1e-3F);
    EXPECT_NEAR(layer(grid, {0, 0, -1}), 0, 1e-5F);
}

TEST(PixelCamera, project_inverts_ray) {
    for (const CameraType type : {CameraType::kPerspective, CameraType::kOrthographic}) {
        const PixelCamera seen_by = camera(type);
        const Ray ray = seen_by.ray(123.5F, 45.25F);
        const Vec3 back = seen_by.project(ray.origin + 3.0F * ray.direction);
        EXPECT_NEAR(back.x, 123.5F, 1e-2F);
        EXPECT_NEAR(back.y, 45.25F, 1e-2F);
        EXPECT_NEAR(back.z, 3, 1e-5F);
    }
}

// So many cells from a vertex: the point's own place says the same.
TEST(PerspectiveGrid, points_near_a_vertex_lie_in_its_cells) {
    for (const DepthLaw law : {DepthLaw::kLogarithmic, DepthLaw::kReciprocal, DepthLaw::kLinear}) {
        const CameraType type = law == DepthLaw::kLinear ? CameraType::kOrthographic : CameraType::kPerspective;
        const PerspectiveGrid grid(camera(type), 700, 350, {20, 1, 10, law});
        const Sequence4 sequence(7);
        for (std::uint32_t i = 0; i < 1000; ++i) {
            const auto vertex = static_cast<std::uint32_t>(sequence(i, 3) * static_cast<float>(grid.vertex_count()));
            const GridPlace at = grid.place(grid.near_vertex(vertex, Vec3(0.0F)));
            float weight = 0;
            for (int k = 0; k < 4; ++k) {
                weight += at.vertices[k] == vertex ? at.weights[k] : 0;
            }
            ASSERT_NEAR(weight, 1, 2e-3F);
            // Towards an edge, face or corner of the eight cells at most its other vertices have a share.
            const Vec3 cells = 2.0F * Vec3(sequence(i, 0), sequence(i, 1), sequence(i, 2)) - Vec3(1.0F);
            const std::uint32_t cell = grid.cell_at(grid.near_vertex(vertex, cells));
            const std::uint32_t own = grid.cell_at(grid.near_vertex(vertex, 0.5F * cells));
            ASSERT_EQ(cell, own);
        }
    }
}

// A cell of 20 pixels is 4 cm wide at 1 m; what lies along the view direction counts by two fifths.
TEST(PerspectiveGrid, cells_between_points_are_counted_as_they_are_seen) {
    const PerspectiveGrid grid(camera(), 700, 350, {20, 1, 10, DepthLaw::kLogarithmic});
    EXPECT_NEAR(grid.cells_between({-0.04F, 0, -1}, {0.04F, 0, -1}), 2, 1e-4F);
    EXPECT_NEAR(grid.cells_between({0, -0.12F, -3}, {0, 0.12F, -3}), 2, 1e-4F);
    EXPECT_NEAR(grid.cells_between({0, 0, -1.9F}, {0, 0, -2.1F}), 0.4F * 0.2F / 0.08F, 1e-4F);
    EXPECT_NEAR(grid.cells_between({-0.15F, 0, -1.9F}, {0.15F, 0, -2.1F}),
                std::sqrt(0.3F * 0.3F + 0.08F * 0.08F) / 0.08F, 1e-4F);
    EXPECT_NEAR(grid.cells_between({0.7F, 0, -1.05F}, {0.7F, 0.1F, -1.05F}),
                grid.cells_between({0.7F, 0.1F, -1.05F}, {0.7F, 0, -1.05F}), 1e-5F);
    // Nearer than the grid and beyond it cells are as large as at its ends.
    EXPECT_NEAR(grid.cells_between({-0.04F, 0, -0.1F}, {0.04F, 0, -0.1F}), 2, 1e-4F);
    EXPECT_NEAR(grid.cells_between({-4, 0, -100}, {4, 0, -100}), 20, 1e-3F);
}

TEST(PerspectiveGrid, cells_of_an_orthographic_camera_are_equally_large) {
    const PerspectiveGrid grid(camera(CameraType::kOrthographic), 700, 350, {20, 1, 10, DepthLaw::kLinear});
    for (const float depth : {1.0F, 3.0F, 9.0F}) {
        EXPECT_NEAR(grid.cells_between({-0.04F, 0.3F, -depth}, {0.04F, 0.3F, -depth}), 2, 1e-4F);
        EXPECT_NEAR(grid.cells_between({0.6F, 0.3F, -depth}, {0.6F, 0.3F, -depth - 0.2F}), 2, 1e-4F);
    }
}

}  // namespace
}  // namespace gg
