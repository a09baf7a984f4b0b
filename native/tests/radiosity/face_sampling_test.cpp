#include "radiosity/face_sampling.h"

#include <gtest/gtest.h>

#include <map>
#include <utility>
#include <vector>

#include "core/random.h"
#include "radiosity/solution_data.h"
#include "support/clouds.h"
#include "support/law_scenes.h"

namespace gg::test {
namespace {

TEST(SamplePrefix, chooses_in_proportion) {
    const std::vector<double> prefix{0, 1, 1, 4, 4.5, 9};
    std::vector<int> counts(5);
    constexpr int kSamples = 9000;
    for (int i = 0; i < kSamples; ++i) {
        ++counts[sample_prefix(prefix, 0, 5, (static_cast<float>(i) + 0.5F) / kSamples)];
    }
    EXPECT_EQ(counts, (std::vector<int>{1000, 0, 3000, 500, 4500}));
}

TEST(SamplePrefix, stays_in_its_range) {
    const std::vector<double> prefix{0, 1, 1, 4, 4.5, 9};
    EXPECT_EQ(sample_prefix(prefix, 2, 4, 0), 2U);
    EXPECT_EQ(sample_prefix(prefix, 2, 4, 0.85F), 2U);
    EXPECT_EQ(sample_prefix(prefix, 2, 4, 0.86F), 3U);
    EXPECT_EQ(sample_prefix(prefix, 2, 4, 1 - 0x1p-24F), 3U);
}

// The last item of a range without any weight is a valid one, too.
TEST(SamplePrefix, survives_a_range_without_weight) {
    const std::vector<double> prefix{0, 1, 1, 1};
    const std::uint32_t item = sample_prefix(prefix, 1, 3, 0.5F);
    EXPECT_GE(item, 1U);
    EXPECT_LT(item, 3U);
}

struct FaceScene {
    FaceScene() : prepared(scene()), hierarchy(prepared.scene, *prepared.colors, prepared.faces()) {}

    static SceneDescription scene() {
        SceneBuilder builder;
        const std::uint32_t grey = builder.material(Rgb(0.5F));
        builder.add_mesh(triangle_cloud({Vec3(0.0F), Vec3(1.0F)}, 50, 0.3F, 1), grey);
        builder.add_mesh(cube_cloud({Vec3(2.0F), Vec3(3.0F)}, 20, 0.2F, 2), grey);
        builder.description.instances[0].to_world.linear = Mat3(3.0F);
        return builder.description;
    }

    Prepared prepared;
    Hierarchy hierarchy;
};

class SampleFace : public ::testing::TestWithParam<Spread> {};

TEST_P(SampleFace, takes_every_face_by_its_weight) {
    const FaceScene scene;
    const bool by_exposure = GetParam() == Spread::kByExposure;
    const Node& root = scene.hierarchy[kGeometryRoot];
    std::vector<std::pair<std::uint32_t, std::uint32_t>> triangles;
    std::vector<double> weights;
    double all = 0;
    scene.hierarchy.for_each_triangle(root, [&](std::uint32_t instance, std::uint32_t triangle) {
        const double face = length(world_area_vector(scene.prepared.scene, instance, triangle));
        const std::uint32_t mesh = scene.prepared.scene.instances[instance].mesh;
        triangles.emplace_back(instance, triangle);
        const Exposure& exposure = scene.hierarchy.faces().meshes[mesh].exposure[triangle];
        weights.push_back(face * (by_exposure ? exposure.sum() : static_cast<float>(exposure.sides())));
        all += weights.back();
    });
    ASSERT_EQ(triangles.size(), 50U + 240U);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> counts;
    constexpr std::uint32_t kSamples = 20000;
    for (std::uint32_t i = 0; i < kSamples; ++i) {
        const float u = (static_cast<float>(i) + 0.5F) / kSamples;
        const FacePoint point =
            sample_face(scene.hierarchy, root, GetParam(), u, unit_float(hash64(i, 0)), unit_float(hash64(i, 1)));
        double nearest = 1e30;
        std::pair<std::uint32_t, std::uint32_t> face;
        for (const auto& [instance, triangle] : triangles) {
            const auto c = world_triangle(scene.prepared.scene, instance, triangle);
            const Vec3 normal = cross(c[1] - c[0], c[2] - c[0]);
            // In the triangle's own weights, with the distance from its plane as third coordinate.
            const double scale = length_squared(normal);
            const double w1 = dot(cross(point.position - c[0], c[2] - c[0]), normal) / scale;
            const double w2 = dot(cross(c[1] - c[0], point.position - c[0]), normal) / scale;
            const double outside = std::max(0.0, std::max({-w1, -w2, w1 + w2 - 1})) * std::sqrt(std::sqrt(scale));
            const double distance = std::abs(dot(point.position - c[0], normal)) / std::sqrt(scale) + outside;
            if (distance < nearest) {
                nearest = distance;
                face = {instance, triangle};
                const float along = dot(point.normal, normal) / std::sqrt(static_cast<float>(scale));
                EXPECT_TRUE(nearest > 1e-5 || along > 0.999F);
            }
        }
        ASSERT_LT(nearest, 1e-5);
        ++counts[face];
    }
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        EXPECT_NEAR(counts[triangles[i]], kSamples * weights[i] / all, 2) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(spreads, SampleFace, ::testing::Values(Spread::kByArea, Spread::kByExposure));

TEST(SampleElement, points_are_even) {
    Prepared prepared(furnace(0.5F, false));
    Hierarchy hierarchy(prepared.scene, *prepared.colors, prepared.faces());
    NodeId id = kGeometryRoot;
    while (hierarchy[id].kind != NodeKind::kElement) {
        hierarchy.open(std::span(&id, 1), prepared.control);
        id = hierarchy[id].first_child;
    }
    const Node& element = hierarchy[id];
    Vec3 mean(0.0F);
    constexpr int kGrid = 64;
    for (int k = 0; k < kGrid * kGrid; ++k) {
        const FacePoint point =
            sample_face(hierarchy, element, Spread::kByArea, 0, (static_cast<float>(k % kGrid) + 0.5F) / kGrid,
                        (static_cast<float>(k / kGrid) + 0.5F) / kGrid);
        mean += point.position / static_cast<float>(kGrid * kGrid);
        EXPECT_EQ(point.normal, element.normal);
    }
    EXPECT_LT(length(mean - element.center), 1e-3F * element.radius);
}

}  // namespace
}  // namespace gg::test
