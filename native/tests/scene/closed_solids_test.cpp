#include "scene/closed_solids.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/control.h"
#include "scene/weld.h"
#include "support/meshes.h"

namespace gg {
namespace {

using test::join;
using test::make_box;
using test::make_mesh;

const Sides kOpen = Sides::kBoth;

std::vector<Sides> sides_of(const MeshDescription& mesh) {
    std::vector<TriangleCorners> triangles;
    for (std::size_t first = 0; first < mesh.triangle_vertices.size(); first += 3) {
        triangles.push_back(
            {mesh.triangle_vertices[first], mesh.triangle_vertices[first + 1], mesh.triangle_vertices[first + 2]});
    }
    return find_lit_sides(mesh.positions, triangles, weld_positions(mesh.positions), Control{});
}

std::vector<Sides> all(std::size_t count, Sides sides) {
    return std::vector<Sides>(count, sides);
}

std::vector<Sides> both(std::vector<Sides> first, const std::vector<Sides>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

TEST(ClosedSolids, a_closed_box_is_lit_from_outside) {
    EXPECT_EQ(sides_of(make_box(Vec3(0), Vec3(1))), all(12, Sides::kFront));
}

TEST(ClosedSolids, far_from_the_origin_the_sign_of_the_volume_holds) {
    EXPECT_EQ(sides_of(make_box(Vec3(90000), Vec3(90001))), all(12, Sides::kFront));
    EXPECT_EQ(sides_of(make_box(Vec3(-90000), Vec3(-89999), true)), all(12, Sides::kBack));
}

TEST(ClosedSolids, an_inside_out_box_is_lit_from_its_back) {
    EXPECT_EQ(sides_of(make_box(Vec3(0), Vec3(1), true)), all(12, Sides::kBack));
}

TEST(ClosedSolids, a_box_without_a_face_is_open) {
    MeshDescription mesh = make_box(Vec3(0), Vec3(1));
    mesh.triangle_vertices.resize(30);
    EXPECT_EQ(sides_of(mesh), all(10, kOpen));
}

TEST(ClosedSolids, a_tetrahedron_without_any_one_face_is_open_however_its_corners_are_numbered) {
    for (std::uint32_t turn = 0; turn < 4; ++turn) {
        MeshDescription mesh =
            make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2});
        std::rotate(mesh.positions.begin(), mesh.positions.begin() + turn, mesh.positions.end());
        for (std::uint32_t& vertex : mesh.triangle_vertices) {
            vertex = (vertex + 4 - turn) % 4;
        }
        EXPECT_EQ(sides_of(mesh), all(4, Sides::kFront));
        for (int face = 0; face < 4; ++face) {
            std::rotate(mesh.triangle_vertices.begin(), mesh.triangle_vertices.begin() + 3,
                        mesh.triangle_vertices.end());
            MeshDescription open = mesh;
            open.triangle_vertices.resize(9);
            EXPECT_EQ(sides_of(open), all(3, kOpen));
        }
    }
}

TEST(ClosedSolids, one_flipped_triangle_opens_a_box) {
    MeshDescription mesh = make_box(Vec3(0), Vec3(1));
    std::swap(mesh.triangle_vertices[0], mesh.triangle_vertices[1]);
    EXPECT_EQ(sides_of(mesh), all(12, kOpen));
}

TEST(ClosedSolids, split_vertices_are_welded_by_position) {
    EXPECT_EQ(sides_of(test::split(make_box(Vec3(-1), Vec3(1)))), all(12, Sides::kFront));
}

TEST(ClosedSolids, components_are_judged_one_by_one) {
    MeshDescription open = make_box(Vec3(10), Vec3(11));
    open.triangle_vertices.resize(30);
    const MeshDescription mesh = join(make_box(Vec3(0), Vec3(1)), open);
    EXPECT_EQ(sides_of(mesh), both(all(12, Sides::kFront), all(10, kOpen)));
}

TEST(ClosedSolids, a_solid_around_another_is_open_on_both_sides_and_the_inner_one_is_not) {
    const MeshDescription mesh = join(make_box(Vec3(0), Vec3(10)), make_box(Vec3(4), Vec3(5)));
    EXPECT_EQ(sides_of(mesh), both(all(12, kOpen), all(12, Sides::kFront)));
}

TEST(ClosedSolids, neighbours_that_share_an_edge_with_four_triangles_are_open) {
    // Two boxes that touch along the edge x = y = 1, welded by position.
    const MeshDescription mesh = join(make_box(Vec3(0, 0, 0), Vec3(1, 1, 1)), make_box(Vec3(1, 1, 0), Vec3(2, 2, 1)));
    EXPECT_EQ(sides_of(mesh), all(24, kOpen));
}

TEST(ClosedSolids, boxes_that_touch_at_a_vertex_stay_two_solids) {
    const MeshDescription mesh = join(make_box(Vec3(0), Vec3(1)), make_box(Vec3(1), Vec3(2), true));
    EXPECT_EQ(sides_of(mesh), both(all(12, Sides::kFront), all(12, Sides::kBack)));
}

TEST(ClosedSolids, a_sheet_with_two_faces_has_no_volume_and_is_open) {
    const MeshDescription mesh = make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2, 0, 2, 1});
    EXPECT_EQ(sides_of(mesh), all(2, kOpen));
}

TEST(ClosedSolids, a_thin_pane_is_closed) {
    EXPECT_EQ(sides_of(make_box({0, 0, 0}, {10, 10, 0.001F})), all(12, Sides::kFront));
}

TEST(ClosedSolids, no_triangles_have_no_sides) {
    EXPECT_TRUE(sides_of(make_mesh({{0, 0, 0}}, {})).empty());
}

}  // namespace
}  // namespace gg
