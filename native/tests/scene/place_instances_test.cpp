#include "scene/place_instances.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/control.h"
#include "core/messages.h"
#include "scene/convert_mesh.h"
#include "support/meshes.h"

namespace gg {
namespace {

const Box kUnitBox{Vec3(0), Vec3(1)};
const Box kFlatBox{Vec3(-1, -1, 2), Vec3(1, 1, 2)};

Affine scaled(Vec3 scale) {
    Affine map;
    for (int axis = 0; axis < 3; ++axis) {
        map.linear[axis][axis] = scale[axis];
    }
    return map;
}

TEST(PlaceInstances, sound_maps_stay_as_they_are) {
    for (const Vec3 scale : {Vec3(1), Vec3(-1, 1, 1), Vec3(0.001F, 5, 1), Vec3(1e-5F), Vec3(1e5F)}) {
        Affine map = scaled(scale);
        map.linear[1].x = 0.3F * map.linear[1].y;  // sheared
        map.translation = {1, 2, 3};
        const std::optional<Affine> result = make_invertible(map, kUnitBox);
        ASSERT_TRUE(result);
        EXPECT_EQ(result->linear, map.linear);
        EXPECT_EQ(result->translation, map.translation);
    }
}

TEST(PlaceInstances, maps_that_collapse_or_are_not_finite_are_refused) {
    for (const Vec3 scale : {Vec3(0), Vec3(1, 0, 0), Vec3(std::numeric_limits<float>::quiet_NaN(), 1, 1),
                             Vec3(kInfinity, 1, 1), Vec3(1e-12F), Vec3(1e20F)}) {
        EXPECT_FALSE(make_invertible(scaled(scale), kUnitBox)) << scale.x << ' ' << scale.y << ' ' << scale.z;
    }
    Affine parallel;
    parallel.linear = Mat3({1, 0, 0}, {2, 0, 0}, {0, 0, 1});
    EXPECT_FALSE(make_invertible(parallel, kUnitBox));
    Affine lost;
    lost.translation.x = kInfinity;
    EXPECT_FALSE(make_invertible(lost, kUnitBox));
}

TEST(PlaceInstances, a_flat_mesh_with_a_flattening_scale_keeps_its_points) {
    const Affine map = scaled({3, 2, 0});
    const std::optional<Affine> result = make_invertible(map, kFlatBox);
    ASSERT_TRUE(result);
    EXPECT_GT(glm::determinant(result->linear), 1);
    for (const Vec3 point : {kFlatBox.lower, kFlatBox.upper, Vec3(-1, 1, 2)}) {
        EXPECT_LT(length(result->point(point) - map.point(point)), 1e-5F);
    }
    EXPECT_LT(length(normalize_or_zero(normal_matrix(result->linear) * Vec3(0, 0, 1)) - Vec3(0, 0, 1)), 1e-6F);
}

TEST(PlaceInstances, a_solid_with_a_flattening_scale_becomes_nearly_flat) {
    const Affine map = scaled({2, 0, 2});
    const std::optional<Affine> result = make_invertible(map, kUnitBox);
    ASSERT_TRUE(result);
    for (const Vec3 point : {Vec3(0), Vec3(1), Vec3(0.2F, 0.9F, 0.4F)}) {
        EXPECT_LT(length(result->point(point) - map.point(point)), 2e-4F);
    }
    EXPECT_GT(std::abs(glm::determinant(result->linear)), 1e-5F);
}

struct Placed {
    std::vector<Mesh> meshes;
    std::vector<InstanceDescription> descriptions;
    Messages messages;

    explicit Placed(const Affine& to_world) {
        meshes.push_back(convert_mesh(test::make_box(Vec3(0), Vec3(1)), Control{}).mesh);
        descriptions.resize(1);
        descriptions[0].name = "object";
        descriptions[0].to_world = to_world;
    }
    std::vector<Instance> instances() { return place_instances(descriptions, meshes, 1, messages); }
};

TEST(PlaceInstances, mirrored_and_sheared_instances_keep_normals_outside_and_bounds_around) {
    for (const float mirror : {1.0F, -1.0F}) {
        Affine map{Mat3({2 * mirror, 0, 0}, {0.5F, 1, 0}, {0, 0.3F, 3}), Vec3(10, 20, 30)};
        Placed placed(map);
        const std::vector<Instance> instances = placed.instances();
        ASSERT_EQ(instances.size(), 1U);
        const Mesh& mesh = placed.meshes[0];
        const Vec3 middle = map.point(Vec3(0.5F));
        for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
            const Vec3 normal = instances[0].normal_to_world * mesh.normals[mesh.shading_vertices[triangle][0]];
            const Vec3 corner = map.point(mesh.positions[mesh.triangles[triangle][0]]);
            EXPECT_GT(dot(normal, corner - middle), 0);
            EXPECT_TRUE(instances[0].bounds.contains(corner));
        }
        EXPECT_TRUE(placed.messages.all().empty());
    }
}

TEST(PlaceInstances, what_cannot_be_placed_is_left_out_with_a_message) {
    Placed placed(scaled(Vec3(0)));
    EXPECT_TRUE(placed.instances().empty());
    const std::vector<Message> messages = placed.messages.all();
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_EQ(messages[0].object, "object");
}

TEST(PlaceInstances, instances_of_empty_or_unknown_meshes_are_left_out_silently) {
    Placed placed{Affine{}};
    placed.meshes.emplace_back();
    placed.descriptions.resize(3, placed.descriptions[0]);
    placed.descriptions[0].mesh = 1;
    placed.descriptions[1].mesh = 2;
    EXPECT_EQ(placed.instances().size(), 1U);
    EXPECT_TRUE(placed.messages.all().empty());
}

TEST(PlaceInstances, lamps_and_whole_instances_inside_mark_the_one_around) {
    Placed placed(scaled(Vec3(10)));
    placed.descriptions.push_back(placed.descriptions[0]);
    placed.descriptions[1].to_world = {Mat3(1.0F), Vec3(4)};
    std::vector<Instance> instances = placed.instances();
    mark_enclosing(instances, {}, Control{});
    EXPECT_TRUE(instances[0].encloses);
    EXPECT_FALSE(instances[1].encloses);

    Lamp lamp;
    lamp.position = Vec3(4.5F);
    mark_enclosing(instances, {&lamp, 1}, Control{});
    EXPECT_TRUE(instances[1].encloses);
    lamp.shape = LampShape::kDistant;  // has no position
    mark_enclosing(instances, {&lamp, 1}, Control{});
    EXPECT_FALSE(instances[1].encloses);

    instances[1].bounds.upper.x = 10.5F;  // sticks out
    mark_enclosing(instances, {}, Control{});
    EXPECT_FALSE(instances[0].encloses);
}

}  // namespace
}  // namespace gg
