#include "trace/surface_point.h"

#include <gtest/gtest.h>

#include "core/control.h"
#include "soup.h"

namespace gg {
namespace {

using test::add_instance;

// One triangle in the plane z = 0 with shading normals and texture coordinates of its own.
Scene one_triangle(const Affine& to_world) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
    mesh.triangles = {{0, 1, 2}};
    mesh.shading_vertices = {{0, 1, 2}};
    mesh.normals = {normalize_or_zero({-1, 0, 1}), {0, 0, 1}, {0, 0, 1}};
    mesh.uvs = {{0.5F, 0.5F}, {1.5F, 0.5F}, {0.5F, 4.5F}};
    Scene scene;
    scene.meshes = {mesh};
    add_instance(scene, 0, to_world);
    return scene;
}

void expect_near(Vec3 a, Vec3 b, float tolerance = 1e-6F) {
    EXPECT_LT(length(a - b), tolerance) << a.x << a.y << a.z;
}

TEST(surface_point, corners_carry_their_own_values) {
    const Scene scene = one_triangle({});
    const SurfacePoint first = surface_point(scene, 0, 0, 0, 0);
    expect_near(first.position, {0, 0, 0});
    expect_near(first.geometric_normal, {0, 0, 1});
    expect_near(first.shading_normal, normalize_or_zero({-1, 0, 1}));
    EXPECT_EQ(first.uv, Vec2(0.5F, 0.5F));
    EXPECT_EQ(surface_point(scene, 0, 0, 1, 0).uv, Vec2(1.5F, 0.5F));
    EXPECT_EQ(surface_point(scene, 0, 0, 0, 1).uv, Vec2(0.5F, 4.5F));
    expect_near(surface_point(scene, 0, 0, 0.25F, 0.5F).position, {0.5F, 1, 0});
}

TEST(surface_point, normals_follow_scaling_and_stay_in_front_when_mirrored) {
    const Scene scaled = one_triangle({Mat3(Vec3(3, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)), {0, 0, 5}});
    expect_near(surface_point(scaled, 0, 0, 0, 0).shading_normal, normalize_or_zero({-1.0F / 3, 0, 1}));
    const Scene mirrored = one_triangle({Mat3(Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)), {0, 0, 0}});
    const SurfacePoint point = surface_point(mirrored, 0, 0, 0, 0);
    expect_near(point.geometric_normal, {0, 0, 1});
    expect_near(point.shading_normal, normalize_or_zero({1, 0, 1}));
}

TEST(surface_point, flat_triangles_shade_with_their_geometric_normal) {
    Scene scene = one_triangle({});
    scene.meshes[0].normals.clear();
    scene.meshes[0].uvs.clear();
    const SurfacePoint point = surface_point(scene, 0, 0, 0.2F, 0.3F);
    expect_near(point.shading_normal, {0, 0, 1});
    EXPECT_EQ(point.uv, Vec2(0));
}

TEST(surface_point, a_placement_without_area_has_no_normal) {
    const Scene scene = one_triangle({Mat3(0), {1, 2, 3}});
    EXPECT_EQ(surface_point(scene, 0, 0, 0.2F, 0.3F).geometric_normal, Vec3(0));
}

TEST(surface_point, offset_rays_do_not_meet_their_own_surface) {
    for (const float distance : {0.0F, 10.0F, 1000.0F, 100000.0F}) {
        Scene scene;
        scene.meshes = {test::make_soup(5, 2000, 0.5F)};
        add_instance(scene, 0, {Mat3(1), Vec3(distance, -distance, 0.5F * distance)});
        const Control control;
        const RayTracer tracer(scene, control);
        test::Dice dice(11);
        for (std::uint32_t triangle = 0; triangle < 2000; ++triangle) {
            const SurfacePoint point = surface_point(scene, 0, triangle, 0.3F, 0.3F);
            const Vec3 random = normalize_or_zero(dice.vector());
            const float side = dice.number() < 0 ? -1.0F : 1.0F;
            const Vec3 normal = side * point.geometric_normal;
            const Vec3 direction = normalize_or_zero(normal + 0.99F * random);
            const Hit hit = tracer.closest_hit({offset_origin(point.position, normal, 1), direction}, RayMask::kLight);
            EXPECT_NE(hit.triangle, triangle) << distance;
        }
    }
}

}  // namespace
}  // namespace gg
