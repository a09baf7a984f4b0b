#include "scene/shading_vertices.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gg {
namespace {

// Two triangles 0 1 2 and 0 2 3.
const std::vector<TriangleCorners> kFan = {{0, 1, 2}, {0, 2, 3}};
const std::vector<std::uint32_t> kSeparate = {0, 1, 2, 3};

TEST(ShadingVertices, corners_with_position_and_normal_in_common_share_one) {
    const std::vector<Vec3> up(6, Vec3(0, 0, 1));
    const ShadingVertices shading = make_shading_vertices(kFan, kSeparate, up, 1e-4F);
    EXPECT_EQ(shading.normals.size(), 4U);
    EXPECT_EQ(shading.triangles[0][0], shading.triangles[1][0]);
    EXPECT_EQ(shading.triangles[0][2], shading.triangles[1][1]);
}

TEST(ShadingVertices, corners_with_other_normals_stay_apart) {
    std::vector<Vec3> normals(6, Vec3(0, 0, 1));
    normals[3] = normals[4] = normals[5] = {0, 1, 0};
    const ShadingVertices shading = make_shading_vertices(kFan, kSeparate, normals, 1e-4F);
    EXPECT_EQ(shading.normals.size(), 6U);
    for (int corner = 0; corner < 3; ++corner) {
        EXPECT_EQ(shading.normals[shading.triangles[0][corner]], Vec3(0, 0, 1));
        EXPECT_EQ(shading.normals[shading.triangles[1][corner]], Vec3(0, 1, 0));
    }
}

TEST(ShadingVertices, tolerance_bounds_the_difference_of_normals) {
    std::vector<Vec3> normals(6, Vec3(0, 0, 1));
    normals[3] = {2e-4F, 0, 1};
    EXPECT_EQ(make_shading_vertices(kFan, kSeparate, normals, 1e-3F).normals.size(), 4U);
    EXPECT_EQ(make_shading_vertices(kFan, kSeparate, normals, 1e-4F).normals.size(), 5U);
}

TEST(ShadingVertices, split_vertices_at_one_position_share_one) {
    const std::vector<TriangleCorners> apart = {{0, 1, 2}, {3, 4, 5}};
    const std::vector<std::uint32_t> welded = {0, 1, 2, 0, 2, 5};
    EXPECT_EQ(make_shading_vertices(apart, welded, std::vector<Vec3>(6, Vec3(1, 0, 0)), 1e-4F).normals.size(), 4U);
}

// Shading vertices of a fan around vertex 0 where triangle i has normal i, and the last triangle the first one's again.
std::size_t count_at_tip(std::uint32_t different_normals) {
    std::vector<TriangleCorners> triangles;
    std::vector<std::uint32_t> welded = {0};
    std::vector<Vec3> normals;
    for (std::uint32_t index = 0; index <= different_normals; ++index) {
        triangles.push_back({0, 2 * index + 1, 2 * index + 2});
        welded.insert(welded.end(), {2 * index + 1, 2 * index + 2});
        const float angle = static_cast<float>(index % different_normals) / static_cast<float>(different_normals);
        normals.insert(normals.end(), 3, Vec3(std::cos(angle), std::sin(angle), 0));
    }
    return make_shading_vertices(triangles, welded, normals, 1e-6F).normals.size() - 2 * triangles.size();
}

TEST(ShadingVertices, only_the_latest_32_normals_of_a_vertex_are_compared) {
    EXPECT_EQ(count_at_tip(32), 32U);
    EXPECT_EQ(count_at_tip(33), 34U);
    EXPECT_EQ(count_at_tip(20000), 20001U);
}

}  // namespace
}  // namespace gg
