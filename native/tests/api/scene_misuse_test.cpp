// Every function that fills a scene, misused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "scenes.h"

namespace gg::test {
namespace {

const float kNan = std::numeric_limits<float>::quiet_NaN();

// Fails, says so, and gives that code.
void expect_failure(gg_status status, gg_status expected) {
    EXPECT_EQ(status, expected);
    EXPECT_STRNE(gg_last_error(), "");
}

void expect_invalid(gg_status status) {
    expect_failure(status, GG_INVALID_ARGUMENT);
}

class SceneMisuse : public ::testing::Test {
  protected:
    Scene scene_;
    std::uint32_t id_ = 77;
    Ground ground_{1, 0};
};

TEST(library, says_what_it_is) {
    EXPECT_EQ(gg_interface_version(), static_cast<std::uint32_t>(GG_INTERFACE_VERSION));
    EXPECT_THAT(gg_version(), ::testing::MatchesRegex("[0-9.]+ \\(Embree [0-9.]+, OpenImageIO [0-9.]+\\)"));
    EXPECT_EQ(gg_processor_supported(), 1);
    EXPECT_NE(gg_last_error(), nullptr);
}

TEST_F(SceneMisuse, null_scenes_are_refused) {
    const gg_image image{};
    const gg_material material = grey_material(1);
    const gg_instances instances{};
    const gg_light light = area_lamp(1);
    const float world[3] = {0, 0, 0};
    expect_invalid(gg_scene_create(nullptr));
    expect_invalid(gg_scene_add_image(nullptr, &image, &id_));
    expect_invalid(gg_scene_add_material(nullptr, &material, &id_));
    expect_invalid(gg_scene_add_mesh(nullptr, &ground_.mesh, &id_));
    expect_invalid(gg_scene_add_instances(nullptr, &instances));
    expect_invalid(gg_scene_add_light(nullptr, &light));
    expect_invalid(gg_scene_set_world(nullptr, world));
    expect_invalid(gg_scene_add_message(nullptr, "object", "text"));
    gg_scene_destroy(nullptr);
}

TEST_F(SceneMisuse, what_is_no_scene_is_refused) {
    std::vector<std::uint64_t> zeros(100, 0);
    auto* no_scene = reinterpret_cast<gg_scene*>(zeros.data());
    expect_invalid(gg_scene_add_mesh(no_scene, &ground_.mesh, &id_));
    gg_scene_destroy(no_scene);
}

TEST_F(SceneMisuse, null_arguments_are_refused) {
    const gg_material material = grey_material(1);
    const float pixels[4] = {};
    gg_image image{};
    image.pixels = pixels;
    image.width = image.height = 1;
    expect_invalid(gg_scene_add_image(scene_.handle, nullptr, &id_));
    expect_invalid(gg_scene_add_image(scene_.handle, &image, nullptr));
    expect_invalid(gg_scene_add_material(scene_.handle, nullptr, &id_));
    expect_invalid(gg_scene_add_material(scene_.handle, &material, nullptr));
    expect_invalid(gg_scene_add_mesh(scene_.handle, nullptr, &id_));
    expect_invalid(gg_scene_add_mesh(scene_.handle, &ground_.mesh, nullptr));
    expect_invalid(gg_scene_add_instances(scene_.handle, nullptr));
    expect_invalid(gg_scene_add_light(scene_.handle, nullptr));
    expect_invalid(gg_scene_set_world(scene_.handle, nullptr));
    EXPECT_EQ(gg_scene_add_message(scene_.handle, nullptr, nullptr), GG_OK);
    EXPECT_EQ(id_, 77U);
}

TEST_F(SceneMisuse, images_need_a_path_or_pixels_and_known_modes) {
    const float pixels[16] = {};
    gg_image image{};
    expect_invalid(gg_scene_add_image(scene_.handle, &image, &id_));
    image.pixels = pixels;
    expect_invalid(gg_scene_add_image(scene_.handle, &image, &id_));
    image.width = image.height = 2;
    for (std::int32_t gg_image::*mode : {&gg_image::color_space, &gg_image::extension, &gg_image::filter_mode}) {
        gg_image broken = image;
        broken.*mode = 9;
        expect_invalid(gg_scene_add_image(scene_.handle, &broken, &id_));
        broken.*mode = -1;
        expect_invalid(gg_scene_add_image(scene_.handle, &broken, &id_));
    }
    EXPECT_EQ(gg_scene_add_image(scene_.handle, &image, &id_), GG_OK);
    EXPECT_EQ(id_, 0U);
}

TEST_F(SceneMisuse, materials_need_finite_factors_and_known_images) {
    for (const float factor : {-1.0F, kNan, std::numeric_limits<float>::infinity()}) {
        const gg_material material = grey_material(factor);
        expect_invalid(gg_scene_add_material(scene_.handle, &material, &id_));
    }
    gg_material material = grey_material(0.5F);
    material.emission.image = 0;
    expect_invalid(gg_scene_add_material(scene_.handle, &material, &id_));
    material.emission.image = GG_NONE;
    material.emission.uv_map[3] = kNan;
    expect_invalid(gg_scene_add_material(scene_.handle, &material, &id_));
    material.emission.uv_map[3] = 0;
    EXPECT_EQ(gg_scene_add_material(scene_.handle, &material, &id_), GG_OK);
    EXPECT_EQ(id_, 0U);
}

TEST_F(SceneMisuse, mesh_indices_are_checked) {
    gg_mesh mesh = ground_.mesh;
    mesh.positions = nullptr;
    expect_invalid(gg_scene_add_mesh(scene_.handle, &mesh, &id_));
    mesh = ground_.mesh;
    mesh.triangle_vertices = nullptr;
    expect_invalid(gg_scene_add_mesh(scene_.handle, &mesh, &id_));
    mesh = ground_.mesh;
    mesh.vertex_count = 3;
    expect_invalid(gg_scene_add_mesh(scene_.handle, &mesh, &id_));
    mesh = ground_.mesh;
    mesh.corner_count = 6;
    expect_invalid(gg_scene_add_mesh(scene_.handle, &mesh, &id_));
    const std::uint32_t corners[6] = {0, 1, 2, 3, 4, 6};
    mesh.triangle_corners = corners;
    expect_invalid(gg_scene_add_mesh(scene_.handle, &mesh, &id_));
    mesh.corner_count = 7;
    EXPECT_EQ(gg_scene_add_mesh(scene_.handle, &mesh, &id_), GG_OK);
    const gg_mesh empty{};
    EXPECT_EQ(gg_scene_add_mesh(scene_.handle, &empty, &id_), GG_OK);
    EXPECT_EQ(id_, 1U);
}

TEST_F(SceneMisuse, instance_ids_and_flags_are_checked) {
    std::uint32_t mesh = 0;
    std::uint32_t material = 0;
    std::uint32_t flags = 4;
    gg_instances instances{};
    instances.count = 1;
    instances.matrices = kIdentity;
    expect_invalid(gg_scene_add_instances(scene_.handle, &instances));
    instances.meshes = &mesh;
    expect_invalid(gg_scene_add_instances(scene_.handle, &instances));
    ASSERT_EQ(gg_scene_add_mesh(scene_.handle, &ground_.mesh, &mesh), GG_OK);
    instances.matrices = nullptr;
    expect_invalid(gg_scene_add_instances(scene_.handle, &instances));
    instances.matrices = kIdentity;
    instances.slot_count = 1;
    expect_invalid(gg_scene_add_instances(scene_.handle, &instances));
    instances.materials = &material;
    expect_invalid(gg_scene_add_instances(scene_.handle, &instances));
    material = GG_NONE;
    instances.flags = &flags;
    expect_invalid(gg_scene_add_instances(scene_.handle, &instances));
    flags = GG_HIDDEN_FROM_CAMERA | GG_HIDDEN_FROM_LIGHT;
    EXPECT_EQ(gg_scene_add_instances(scene_.handle, &instances), GG_OK);
}

TEST_F(SceneMisuse, lights_and_worlds_are_checked) {
    gg_light light = area_lamp(1);
    light.type = 4;
    expect_invalid(gg_scene_add_light(scene_.handle, &light));
    light = area_lamp(1);
    light.shape = -1;
    expect_invalid(gg_scene_add_light(scene_.handle, &light));
    const float negative[3] = {0, -1, 0};
    const float broken[3] = {0, 0, kNan};
    expect_invalid(gg_scene_set_world(scene_.handle, negative));
    expect_invalid(gg_scene_set_world(scene_.handle, broken));
}

TEST_F(SceneMisuse, a_rendered_scene_is_frozen) {
    ASSERT_TRUE(fill_scene(scene_.handle, ground_.mesh));
    const gg_camera camera = camera_above();
    const gg_settings settings = small_settings();
    Render render;
    ASSERT_EQ(gg_render_start(scene_.handle, &camera, &settings, &render.handle), GG_OK);
    const float pixels[4] = {};
    gg_image image{};
    image.pixels = pixels;
    image.width = image.height = 1;
    const gg_material material = grey_material(1);
    const gg_instances instances{};
    const gg_light light = area_lamp(1);
    const float world[3] = {1, 1, 1};
    expect_failure(gg_scene_add_image(scene_.handle, &image, &id_), GG_WRONG_STATE);
    expect_failure(gg_scene_add_material(scene_.handle, &material, &id_), GG_WRONG_STATE);
    expect_failure(gg_scene_add_mesh(scene_.handle, &ground_.mesh, &id_), GG_WRONG_STATE);
    expect_failure(gg_scene_add_instances(scene_.handle, &instances), GG_WRONG_STATE);
    expect_failure(gg_scene_add_light(scene_.handle, &light), GG_WRONG_STATE);
    expect_failure(gg_scene_set_world(scene_.handle, world), GG_WRONG_STATE);
    expect_failure(gg_scene_add_message(scene_.handle, "object", "text"), GG_WRONG_STATE);
}

}  // namespace
}  // namespace gg::test
