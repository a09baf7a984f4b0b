#include "scene/build_scene.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/control.h"
#include "core/messages.h"
#include "core/parallel.h"
#include "core/random.h"
#include "support/meshes.h"

namespace gg {
namespace {

using test::make_box;
using test::make_mesh;

struct Built {
    Scene scene;
    std::vector<Message> messages;
};

Built build(const SceneDescription& description) {
    Messages messages;
    Scene scene = build_scene(description, Control{}, messages);
    return {std::move(scene), messages.all()};
}

SceneDescription describe(std::vector<MeshDescription> meshes) {
    SceneDescription description;
    description.meshes = std::move(meshes);
    description.material_lists = {{0, 5}};
    description.materials.resize(1);
    for (std::uint32_t mesh = 0; mesh < description.meshes.size(); ++mesh) {
        InstanceDescription instance;
        instance.name = "object " + std::to_string(mesh);
        instance.mesh = mesh;
        instance.to_world.translation.x = 10 * static_cast<float>(mesh);
        instance.stable_id = 100 + mesh;
        instance.flags = mesh;
        description.instances.push_back(instance);
    }
    return description;
}

TEST(BuildScene, an_empty_description_is_an_empty_scene) {
    const Built built = build({});
    EXPECT_TRUE(built.scene.instances.empty());
    EXPECT_TRUE(built.scene.lamps.empty());
    EXPECT_EQ(built.scene.world, Rgb(0));
    EXPECT_TRUE(built.messages.empty());
}

TEST(BuildScene, a_sound_scene_has_no_messages_and_keeps_its_numbers) {
    SceneDescription description = describe({make_box(Vec3(0), Vec3(1)), make_box(Vec3(0), Vec3(2))});
    description.world = Rgb(0.1F, 0.2F, 0.3F);
    description.lights.resize(1);
    description.lights[0].power = Rgb(10);
    description.lights[0].to_world.translation = Vec3(-5);
    const Built built = build(description);
    EXPECT_TRUE(built.messages.empty());
    ASSERT_EQ(built.scene.instances.size(), 2U);
    EXPECT_EQ(built.scene.instances[1].stable_id, 101U);
    EXPECT_EQ(built.scene.instances[1].flags, 1U);
    EXPECT_EQ(built.scene.instances[1].name, "object 1");
    EXPECT_EQ(built.scene.instances[1].bounds.upper, Vec3(12, 2, 2));
    EXPECT_EQ(built.scene.lamps.size(), 1U);
    EXPECT_EQ(built.scene.world, Rgb(0.1F, 0.2F, 0.3F));
    EXPECT_EQ(built.scene.sides_of(0, 0), Sides::kFront);
}

TEST(BuildScene, each_kind_of_broken_triangle_is_one_message_a_mesh_with_its_count) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    MeshDescription mesh = make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {nan, 0, 0}},
                                     {0, 1, 2, 0, 0, 1, 1, 1, 2, 0, 1, 3, 0, 1, 4, 0, 1, 9});
    mesh.name = "broken";
    const Built built = build(describe({mesh}));
    ASSERT_EQ(built.messages.size(), 4U);
    for (const Message& message : built.messages) {
        EXPECT_EQ(message.object, "broken");
        EXPECT_EQ(message.count, message.text.find("twice") != std::string::npos ? 2U : 1U) << message.text;
    }
    ASSERT_EQ(built.scene.instances.size(), 1U);
    EXPECT_EQ(built.scene.meshes[0].triangles.size(), 1U);
}

TEST(BuildScene, a_mesh_without_usable_triangles_says_so_and_its_instances_vanish) {
    const Built built = build(describe({make_mesh({{0, 0, 0}, {1, 0, 0}}, {0, 0, 1}), make_box(Vec3(0), Vec3(1))}));
    ASSERT_EQ(built.messages.size(), 2U);
    EXPECT_NE(built.messages[1].text.find("No triangle"), std::string::npos);
    ASSERT_EQ(built.scene.instances.size(), 1U);
    EXPECT_EQ(built.scene.instances[0].mesh, 1U);  // meshes keep their index
    EXPECT_EQ(built.scene.meshes.size(), 2U);
}

TEST(BuildScene, a_mesh_that_had_no_triangles_vanishes_silently) {
    const Built built = build(describe({make_mesh({{0, 0, 0}}, {}), make_mesh({}, {})}));
    EXPECT_TRUE(built.messages.empty());
    EXPECT_TRUE(built.scene.instances.empty());
}

TEST(BuildScene, attributes_that_do_not_fit_are_a_message) {
    MeshDescription mesh = make_box(Vec3(0), Vec3(1));
    mesh.triangle_slots = {0, 1};
    const Built built = build(describe({mesh}));
    ASSERT_EQ(built.messages.size(), 1U);
    EXPECT_NE(built.messages[0].text.find("ignored"), std::string::npos);
}

TEST(BuildScene, slots_beyond_the_list_read_its_last_and_unknown_materials_none) {
    MeshDescription mesh = make_box(Vec3(0), Vec3(1));
    mesh.triangle_slots.assign(12, 0);
    mesh.triangle_slots[1] = 1;
    mesh.triangle_slots[2] = 99;
    const Built built = build(describe({mesh}));
    EXPECT_EQ(built.scene.material_of(0, 0), 0U);
    EXPECT_EQ(built.scene.material_of(0, 1), kNone);  // names material 5 of 1
    EXPECT_EQ(built.scene.material_of(0, 2), kNone);
}

TEST(BuildScene, instances_without_any_material_list_have_no_material) {
    SceneDescription description = describe({make_box(Vec3(0), Vec3(1))});
    description.material_lists.clear();
    EXPECT_EQ(build(description).scene.material_of(0, 0), kNone);
}

TEST(BuildScene, a_lamp_in_a_closed_box_lights_both_of_its_sides) {
    SceneDescription description = describe({make_box(Vec3(0), Vec3(1))});
    EXPECT_EQ(build(description).scene.sides_of(0, 3), Sides::kFront);
    description.lights.resize(1);
    description.lights[0].power = Rgb(1);
    description.lights[0].to_world.translation = Vec3(0.5F);
    EXPECT_EQ(build(description).scene.sides_of(0, 3), Sides::kBoth);
}

TEST(BuildScene, a_broken_world_is_black_with_a_message) {
    for (const float bad : {-1.0F, kInfinity, std::numeric_limits<float>::quiet_NaN()}) {
        SceneDescription description;
        description.world = Rgb(1, bad, 1);
        const Built built = build(description);
        EXPECT_EQ(built.scene.world, Rgb(0));
        EXPECT_EQ(built.messages.size(), 1U);
    }
}

TEST(BuildScene, thread_count_changes_nothing) {
    std::vector<MeshDescription> meshes;
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        MeshDescription mesh = make_mesh({}, {});
        mesh.name = "mesh " + std::to_string(seed);
        for (std::uint64_t index = 0; index < 3000; ++index) {
            const Sequence4 place(hash64(seed, index));
            mesh.positions.push_back(glm::floor(8.0F * Vec3(place(0, 0), place(0, 1), place(0, 2))));
            mesh.triangle_vertices.push_back(static_cast<std::uint32_t>(hash64(index, seed) % 3100));
        }
        meshes.push_back(std::move(mesh));
    }
    const SceneDescription description = describe(std::move(meshes));
    Built first, other;
    run_with_threads(1, [&] { first = build(description); });
    run_with_threads(7, [&] { other = build(description); });
    ASSERT_EQ(first.messages.size(), other.messages.size());
    for (std::size_t index = 0; index < first.messages.size(); ++index) {
        EXPECT_EQ(first.messages[index].object, other.messages[index].object);
        EXPECT_EQ(first.messages[index].count, other.messages[index].count);
    }
    for (std::size_t index = 0; index < first.scene.meshes.size(); ++index) {
        EXPECT_EQ(first.scene.meshes[index].triangles, other.scene.meshes[index].triangles);
        EXPECT_EQ(first.scene.meshes[index].normals, other.scene.meshes[index].normals);
        EXPECT_EQ(first.scene.meshes[index].shading_vertices, other.scene.meshes[index].shading_vertices);
        EXPECT_EQ(first.scene.meshes[index].sides, other.scene.meshes[index].sides);
    }
}

TEST(BuildScene, stops_when_cancelled) {
    Control control;
    control.cancel();
    Messages messages;
    EXPECT_THROW((void)build_scene(describe({make_box(Vec3(0), Vec3(1))}), control, messages), Cancelled);
}

}  // namespace
}  // namespace gg
