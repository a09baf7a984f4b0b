// Objects of many small faces exchange light as clusters: their power must be what it is face by face.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "support/clouds.h"
#include "support/law_scenes.h"
#include "support/solution_measures.h"

namespace gg::test {
namespace {

struct ClusterScene {
    const char* name;
    std::function<void(SceneBuilder&, std::uint32_t)> add_object;
    double tolerance;  // share of the reflected power of room and object together, and of the object's alone
    double object_tolerance;
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

// The finer solution still has clusters, but two hundred times as many links.
TEST_P(Clustering, reflects_as_much_as_a_fine_solution) {
    SceneBuilder builder;
    const std::uint32_t wall = builder.material(Rgb(0.6F));
    const std::uint32_t object = builder.material(Rgb(0.5F));
    const std::uint32_t ceiling = builder.material(Rgb(0.6F), Rgb(1.0F));
    builder.box(Vec3(0.0F), kRoomSize, {wall, wall, wall, wall, wall, ceiling}, true);
    GetParam().add_object(builder, object);
    double power[2], object_power[2];
    for (const bool fine : {false, true}) {
        Prepared prepared(builder.description);
        const auto solution = prepared.solve(fine ? 0.004F : 0.02F);
        const FaceMeans means = means_of_instance(*solution, 6);
        power[fine] = reflected_power(*solution);
        object_power[fine] = means.area * luminance_of(means.irradiance);
        printf("%s fine %d power %.4f object %.4f leaves %zu links %zu %s\n", GetParam().name, fine, power[fine],
               object_power[fine], surface_leaves(*solution).size(), solution->links.all.size(),
               prepared.statistics.json().substr(0, 90).c_str());
    }
    EXPECT_NEAR(power[0] / power[1], 1, GetParam().tolerance);
    EXPECT_NEAR(object_power[0] / object_power[1], 1, GetParam().object_tolerance);
}

std::string name_of(const testing::TestParamInfo<ClusterScene>& info) {
    return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Objects, Clustering,
                         testing::Values(ClusterScene{"sphere", add_sphere, 0.03, 0.05},
                                         ClusterScene{"leaves", add_leaves, 0.03, 0.05},
                                         ClusterScene{"cubes", add_cubes, 0.03, 0.05}),
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
    const auto solution = prepared.solve(0.02F);
    const double area = kCount * 6.0 * kEdge * kEdge;
    const double expected = std::exp(-area * kDepth / (4.0 * kSide * kSide * kDepth));
    const double reached = luminance_of(means_of_instance(*solution, 0).irradiance) / 100;
    printf("depth %g expected %g reached %g\n", -std::log(expected), expected, reached);
    EXPECT_NEAR(reached / expected, 1, 0.05);
}

}  // namespace
}  // namespace gg::test
