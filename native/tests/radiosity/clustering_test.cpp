// Objects of many small faces exchange light as clusters: they and the room around
// them must receive what random walks find.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "oracles/path_irradiance.h"
#include "support/clouds.h"
#include "support/face_points.h"
#include "support/law_scenes.h"
#include "support/solution_measures.h"

namespace gg::test {
namespace {

struct ClusterScene {
    const char* name;
    std::function<void(SceneBuilder&, std::uint32_t)> add_object;
    float quality;
    double room_tolerance, object_tolerance;  // of the power that arrives, share of it
};

void add_sphere(SceneBuilder& builder, std::uint32_t material) {
    builder.sphere({2, 1.5F, 1}, 0.6F, 20, material, false);
}
void add_leaves(SceneBuilder& builder, std::uint32_t material) {
    builder.add_mesh(triangle_cloud({{1.2F, 0.8F, 0.2F}, {2.8F, 2.2F, 1.6F}}, 2000, 0.1F, 3), material);
}
void add_cubes(SceneBuilder& builder, std::uint32_t material) {
    builder.add_mesh(cube_cloud({{1.2F, 0.8F, 0.2F}, {2.8F, 2.2F, 1.6F}}, 200, 0.1F, 3), material);
}

class Clustering : public testing::TestWithParam<ClusterScene> {};

TEST_P(Clustering, receives_as_much_as_random_walks_say) {
    SceneBuilder builder;
    const std::uint32_t wall = builder.material(Rgb(0.6F));
    const std::uint32_t object = builder.material(Rgb(0.5F));
    const std::uint32_t ceiling = builder.material(Rgb(0.6F), Rgb(1.0F));
    builder.box(Vec3(0.0F), kRoomSize, {wall, wall, wall, wall, wall, ceiling}, true);
    GetParam().add_object(builder, object);
    Prepared prepared(builder.description);
    const oracle::WalkedScene walked{prepared.scene, *prepared.colors, *prepared.tracer};
    const auto solution = prepared.solve(GetParam().quality);
    const Hierarchy& hierarchy = solution->hierarchy;
    double room = 0, true_room = 0, things = 0, true_things = 0;
    for (const Node& node : hierarchy.nodes()) {
        if (node.kind != NodeKind::kCluster || hierarchy[node.parent].kind != NodeKind::kInstances) {
            continue;
        }
        const auto id = static_cast<NodeId>(&node - hierarchy.nodes().data());
        const double area = FacePoints(hierarchy, node).area();
        const double power = area * luminance(solution->lighting.irradiance(id));
        const double truth = area * luminance_of(oracle::mean_irradiance(walked, hierarchy, node, 40000));
        (node.instance == 6 ? things : room) += power;
        (node.instance == 6 ? true_things : true_room) += truth;
    }
    EXPECT_NEAR(room / true_room, 1, GetParam().room_tolerance);
    EXPECT_NEAR(things / true_things, 1, GetParam().object_tolerance);
}

std::string name_of(const testing::TestParamInfo<ClusterScene>& info) {
    return std::string(info.param.name) + (info.param.quality < 0.01F ? "_fine" : "_coarse");
}

INSTANTIATE_TEST_SUITE_P(Objects, Clustering,
                         testing::Values(ClusterScene{"sphere", add_sphere, 0.02F, 0.03, 0.03},
                                         ClusterScene{"sphere", add_sphere, 0.005F, 0.02, 0.02},
                                         ClusterScene{"leaves", add_leaves, 0.02F, 0.03, 0.18},
                                         ClusterScene{"leaves", add_leaves, 0.005F, 0.02, 0.1},
                                         ClusterScene{"cubes", add_cubes, 0.02F, 0.03, 0.2},
                                         ClusterScene{"cubes", add_cubes, 0.005F, 0.02, 0.14}),
                         name_of);

// Small convex bodies at random let exp(-A d / (4 V)) of a beam through [Sillion 1995, eq. 15]; A counts all faces.
TEST(Clustering, cloud_of_cubes_weakens_a_beam_exponentially) {
    constexpr float kEdge = 0.05F, kSide = 2.4F, kDepth = 0.8F;
    SceneBuilder builder;
    const std::uint32_t black = builder.material(Rgb(0.0F));
    builder.quad({0.4F, 0.4F, 0}, {2, 0.4F, 0}, {2, 2, 0}, {0.4F, 2, 0}, black, "floor");
    constexpr std::uint32_t kCount = 900;
    builder.add_mesh(cube_cloud({{0, 0, 0.5F}, {kSide, kSide, 0.5F + kDepth}}, kCount, kEdge, 4), black);
    builder.sun({0, 0, -1}, Rgb(100));
    Prepared prepared(builder.description);
    const auto solution = prepared.solve(0.005F);
    const double area = kCount * 6.0 * kEdge * kEdge;
    const double expected = std::exp(-area * kDepth / (4.0 * kSide * kSide * kDepth));
    const double reached = luminance_of(means_of_instance(*solution, 0).irradiance) / 100;
    EXPECT_NEAR(reached / expected, 1, 0.05);
}

}  // namespace
}  // namespace gg::test
