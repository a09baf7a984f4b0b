#include "film/camera.h"

#include <gtest/gtest.h>

namespace gg {
namespace {

void expect_near(Vec3 a, Vec3 b) {
    EXPECT_LT(length(a - b), 1e-5F) << a.x << " " << a.y << " " << a.z;
}

CameraDescription make_camera(CameraType type) {
    CameraDescription camera;
    camera.type = type;
    const float window[4] = {-1, 1, -0.5F, 0.5F};
    std::copy(std::begin(window), std::end(window), camera.window);
    camera.clip_start = 0.1F;
    camera.clip_end = 100;
    return camera;
}

TEST(camera, perspective_rays_pass_through_the_window_at_distance_one) {
    const PixelCamera camera(make_camera(CameraType::kPerspective), 200, 100);
    const Ray centre = camera.ray(100, 50);
    expect_near(centre.origin, {0, 0, 0});
    expect_near(centre.direction, {0, 0, -1});
    EXPECT_FLOAT_EQ(centre.near, 0.1F);
    EXPECT_FLOAT_EQ(centre.far, 100);
    expect_near(camera.ray(0, 0).direction, {-1, -0.5F, -1});
    expect_near(camera.ray(200, 100).direction, {1, 0.5F, -1});
    EXPECT_NEAR(camera.pixel_size(3), 0.03F, 1e-6F);
}

TEST(camera, orthographic_rays_are_parallel_and_start_in_the_window) {
    const PixelCamera camera(make_camera(CameraType::kOrthographic), 200, 100);
    expect_near(camera.ray(0, 100).origin, {-1, 0.5F, 0});
    expect_near(camera.ray(150, 50).origin, {0.5F, 0, 0});
    expect_near(camera.ray(0, 100).direction, {0, 0, -1});
    EXPECT_NEAR(camera.pixel_size(3), 0.01F, 1e-6F);
}

TEST(camera, placement_turns_and_moves_rays) {
    CameraDescription description = make_camera(CameraType::kPerspective);
    // Camera X, Y, Z lie along world Y, Z, X: it looks along -X.
    description.to_world = {Mat3(Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 0, 0)), {5, 6, 7}};
    const PixelCamera camera(description, 200, 100);
    expect_near(camera.ray(100, 50).origin, {5, 6, 7});
    expect_near(camera.ray(100, 50).direction, {-1, 0, 0});
    expect_near(camera.ray(200, 50).direction, {-1, 1, 0});
    expect_near(camera.ray(100, 100).direction, {-1, 0, 0.5F});
}

TEST(camera, shifted_windows_shift_the_picture) {
    CameraDescription description = make_camera(CameraType::kPerspective);
    description.window[0] = 0;
    const PixelCamera camera(description, 200, 100);
    expect_near(camera.ray(0, 50).direction, {0, 0, -1});
    expect_near(camera.ray(200, 50).direction, {1, 0, -1});
}

TEST(camera, a_perspective_camera_sees_points_along_the_line_to_them) {
    CameraDescription description = make_camera(CameraType::kPerspective);
    description.to_world.translation = {5, 6, 7};
    const PixelCamera camera(description, 200, 100);
    expect_near(camera.direction_to({5, 6, 2}), {0, 0, -1});
    expect_near(camera.direction_to({8, 6, 3}), {0.6F, 0, -0.8F});
    const Ray ray = camera.ray(30, 70);
    expect_near(camera.direction_to(ray.origin + 7.0F * ray.direction), normalize_or_zero(ray.direction));
}

TEST(camera, an_orthographic_camera_sees_all_points_along_its_axis) {
    CameraDescription description = make_camera(CameraType::kOrthographic);
    // Camera X, Y, Z lie along world Y, Z, X: it looks along -X.
    description.to_world = {Mat3(Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 0, 0)), {5, 6, 7}};
    const PixelCamera camera(description, 200, 100);
    expect_near(camera.direction_to({0, 6, 7}), {-1, 0, 0});
    expect_near(camera.direction_to({3, 90, -40}), {-1, 0, 0});
}

}  // namespace
}  // namespace gg
