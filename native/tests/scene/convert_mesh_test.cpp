#include "scene/convert_mesh.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/control.h"
#include "support/meshes.h"

namespace gg {
namespace {

using test::add_corners;
using test::make_box;
using test::make_mesh;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

const std::vector<Vec3> kSquare = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
const std::vector<std::uint32_t> kSquareTriangles = {0, 1, 2, 0, 2, 3};

std::uint32_t count_of(const ConvertedMesh& converted, TriangleFault fault) {
    return converted.count[static_cast<std::size_t>(fault)];
}

// A sound triangle and then one that is not.
void expect_second_left_out(const std::vector<Vec3>& positions, const std::vector<std::uint32_t>& second,
                            TriangleFault fault) {
    std::vector<std::uint32_t> triangles = {0, 1, 2};
    triangles.insert(triangles.end(), second.begin(), second.end());
    const ConvertedMesh converted = convert_mesh(make_mesh(positions, triangles), Control{});
    EXPECT_EQ(count_of(converted, fault), 1U);
    EXPECT_EQ(count_of(converted, TriangleFault::kUsable), 1U);
    ASSERT_EQ(converted.mesh.triangles.size(), 1U);
    EXPECT_EQ(converted.mesh.triangles[0], (TriangleCorners{0, 1, 2}));
    EXPECT_EQ(converted.mesh.sides.size(), 1U);
    EXPECT_EQ(converted.mesh.shading_vertices.size(), 1U);
    for (const Vec3 position : converted.mesh.positions) {
        EXPECT_TRUE(is_finite(position));
    }
    EXPECT_EQ(converted.mesh.bounds.upper, Vec3(1, 1, 0));
}

TEST(ConvertMesh, a_triangle_that_uses_a_vertex_twice_is_left_out) {
    expect_second_left_out(kSquare, {0, 3, 0}, TriangleFault::kRepeatedVertex);
}

TEST(ConvertMesh, a_triangle_beyond_the_vertices_is_left_out) {
    expect_second_left_out(kSquare, {0, 2, 4}, TriangleFault::kBadIndex);
}

TEST(ConvertMesh, a_triangle_with_a_coordinate_that_is_not_finite_is_left_out) {
    for (const float bad : {kNan, kInfinity, 1e30F}) {
        std::vector<Vec3> positions = kSquare;
        positions[3].y = bad;
        expect_second_left_out(positions, {0, 2, 3}, TriangleFault::kNotFinite);
    }
}

TEST(ConvertMesh, a_triangle_without_area_is_left_out) {
    std::vector<Vec3> positions = kSquare;
    positions[3] = {0.5F, 0.5F, 0};  // on the diagonal
    expect_second_left_out(positions, {0, 2, 3}, TriangleFault::kNoArea);
    positions[3] = positions[0];
    expect_second_left_out(positions, {0, 2, 3}, TriangleFault::kNoArea);
}

TEST(ConvertMesh, thin_and_small_triangles_are_kept) {
    const ConvertedMesh thin = convert_mesh(make_mesh({{0, 0, 0}, {100, 0, 0}, {50, 0.001F, 0}}, {0, 1, 2}), Control{});
    EXPECT_EQ(thin.mesh.triangles.size(), 1U);
    const ConvertedMesh small =
        convert_mesh(make_mesh({{0, 0, 0}, {1e-7F, 0, 0}, {0, 1e-7F, 0}}, {0, 1, 2}), Control{});
    ASSERT_EQ(small.mesh.triangles.size(), 1U);
    EXPECT_EQ(small.mesh.normals[0], Vec3(0, 0, 1));
}

TEST(ConvertMesh, a_triangle_beyond_the_corners_is_left_out) {
    MeshDescription mesh = make_mesh(kSquare, kSquareTriangles);
    add_corners(mesh, {}, std::vector<Vec2>(6, Vec2(0.5F)));
    mesh.triangle_corners[4] = 6;
    const ConvertedMesh converted = convert_mesh(mesh, Control{});
    EXPECT_EQ(count_of(converted, TriangleFault::kBadIndex), 1U);
    EXPECT_EQ(converted.mesh.triangles.size(), 1U);
    EXPECT_EQ(converted.mesh.uvs.size(), 3U);
}

TEST(ConvertMesh, every_fault_has_a_text) {
    EXPECT_STREQ(fault_text(TriangleFault::kUsable), "");
    for (std::size_t fault = 1; fault < kTriangleFaults; ++fault) {
        EXPECT_STRNE(fault_text(static_cast<TriangleFault>(fault)), "");
    }
}

TEST(ConvertMesh, coplanar_flat_triangles_share_shading_vertices_and_a_fold_does_not) {
    const Mesh flat = convert_mesh(make_mesh(kSquare, kSquareTriangles), Control{}).mesh;
    EXPECT_EQ(flat.normals, std::vector<Vec3>(4, Vec3(0, 0, 1)));
    std::vector<Vec3> positions = kSquare;
    positions[3].z = 0.5F;
    const Mesh folded = convert_mesh(make_mesh(positions, kSquareTriangles), Control{}).mesh;
    EXPECT_EQ(folded.normals.size(), 6U);
}

TEST(ConvertMesh, a_box_has_four_shading_vertices_a_face) {
    const Mesh mesh = convert_mesh(make_box(Vec3(0), Vec3(1)), Control{}).mesh;
    EXPECT_EQ(mesh.normals.size(), 24U);
    EXPECT_EQ(mesh.sides, std::vector<Sides>(12, Sides::kFront));
}

TEST(ConvertMesh, corner_normals_are_made_unit_and_broken_ones_become_geometric) {
    MeshDescription mesh = make_mesh(kSquare, {0, 1, 2});
    add_corners(mesh, {{0, 3, 4}, {0, 0, 0}, {kNan, 0, 1}}, {});
    const Mesh converted = convert_mesh(mesh, Control{}).mesh;
    const auto normal = [&](int corner) { return converted.normals[converted.shading_vertices[0][corner]]; };
    EXPECT_LT(length(normal(0) - Vec3(0, 0.6F, 0.8F)), 1e-6F);
    EXPECT_EQ(normal(1), Vec3(0, 0, 1));
    EXPECT_EQ(normal(2), Vec3(0, 0, 1));
}

TEST(ConvertMesh, corners_and_slots_follow_the_triangles_that_are_kept) {
    MeshDescription mesh = make_mesh(kSquare, {0, 0, 1, 0, 1, 2, 0, 2, 3});
    add_corners(mesh, {}, {{9, 9}, {9, 9}, {9, 9}, {0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {kNan, kInfinity}});
    mesh.triangle_slots = {7, 1, 2};
    const Mesh converted = convert_mesh(mesh, Control{}).mesh;
    EXPECT_EQ(converted.slots, (std::vector<std::uint32_t>{1, 2}));
    EXPECT_EQ(converted.uvs, (std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 0}}));
}

TEST(ConvertMesh, attributes_of_the_wrong_length_are_ignored) {
    MeshDescription mesh = make_mesh(kSquare, kSquareTriangles);
    EXPECT_FALSE(convert_mesh(mesh, Control{}).ignored_attributes);
    mesh.triangle_slots = {0};
    mesh.triangle_corners = {0, 1};
    mesh.corner_normals = {{0, 0, 1}};
    const ConvertedMesh converted = convert_mesh(mesh, Control{});
    EXPECT_TRUE(converted.ignored_attributes);
    EXPECT_TRUE(converted.mesh.slots.empty());
    EXPECT_EQ(converted.mesh.normals.size(), 4U);
}

TEST(ConvertMesh, flat_triangles_that_are_left_out_still_close_a_solid) {
    // The face z = 0 gets a vertex in the middle of the edge 2 3, and a triangle without area between.
    MeshDescription mesh = make_box(Vec3(0), Vec3(2));
    mesh.positions.emplace_back(1, 2, 0);
    mesh.triangle_vertices = {0, 2, 8, 0, 8, 3, 8, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5,
                              0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
    const ConvertedMesh converted = convert_mesh(mesh, Control{});
    EXPECT_EQ(count_of(converted, TriangleFault::kNoArea), 1U);
    EXPECT_EQ(converted.mesh.sides, std::vector<Sides>(13, Sides::kFront));
}

TEST(ConvertMesh, triangles_that_collapse_into_an_edge_leave_a_solid_closed) {
    // A second vertex at the position of vertex 0: the sliver 0 8 1 closes nothing and opens nothing.
    MeshDescription mesh = make_box(Vec3(0), Vec3(2));
    mesh.positions.push_back(mesh.positions[0]);
    mesh.triangle_vertices.insert(mesh.triangle_vertices.end(), {0, 8, 1});
    const ConvertedMesh converted = convert_mesh(mesh, Control{});
    EXPECT_EQ(count_of(converted, TriangleFault::kNoArea), 1U);
    EXPECT_EQ(converted.mesh.sides, std::vector<Sides>(12, Sides::kFront));
}

TEST(ConvertMesh, bounds_are_those_of_used_vertices) {
    std::vector<Vec3> positions = kSquare;
    positions.emplace_back(99, 99, 99);
    const Mesh mesh = convert_mesh(make_mesh(positions, kSquareTriangles), Control{}).mesh;
    EXPECT_EQ(mesh.bounds.lower, Vec3(0));
    EXPECT_EQ(mesh.bounds.upper, Vec3(1, 1, 0));
}

TEST(ConvertMesh, nothing_usable_gives_a_mesh_without_triangles) {
    EXPECT_TRUE(convert_mesh(make_mesh({}, {}), Control{}).mesh.triangles.empty());
    const Mesh mesh = convert_mesh(make_mesh(kSquare, {0, 0, 1}), Control{}).mesh;
    EXPECT_TRUE(mesh.triangles.empty());
    EXPECT_TRUE(mesh.positions.empty());
    EXPECT_TRUE(mesh.bounds.empty());
}

}  // namespace
}  // namespace gg
