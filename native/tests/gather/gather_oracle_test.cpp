// Gathers at random points held against dense rays into the same solution.
#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "oracles/solution_irradiance.h"
#include "support/gathered.h"
#include "support/grid_picture.h"
#include "support/law_scenes.h"

namespace gg::test {
namespace {

// Random points of everything, each its own site: the default's light is that of dense rays into the same solution.
struct Agreement {
    double mean = 0, rms = 0;  // ours over the oracle's
};

Agreement agreement(const SceneDescription& description, bool full) {
    constexpr std::uint32_t kPoints = 40;
    Gathered room(description);
    const Scene& scene = room.prepared.scene;
    FullGather full_gather = room.full();
    Classifier classifier = room.classifier(0.03F);
    Shader shader = room.shader();
    const Sequence4 sequence(8);
    double ours = 0, truth = 0, squares = 0;
    std::uint32_t taken = 0;
    for (std::uint32_t i = 0; taken < kPoints; ++i) {
        const auto instance = static_cast<std::uint32_t>(sequence(i, 0) * static_cast<float>(scene.instances.size()));
        const auto triangles = static_cast<float>(scene.meshes[scene.instances[instance].mesh].triangles.size());
        const Vec3 w = square_to_triangle(sequence(i, 2), sequence(i, 3));
        Fragment at = fragment_at(scene, instance, static_cast<std::uint32_t>(sequence(i, 1) * triangles), {w.y, w.z});
        at.shading_normal = at.normal;
        Receiver receiver = receiver_at(*room.solution, at);
        if (receiver.place == kNone) {
            continue;
        }
        const double exact = static_cast<double>(luminance(Rgb(oracle::solution_irradiance(
            *room.solution, *room.prepared.tracer, receiver.position, at.normal, 1U << 14U))));
        receiver.irradiance = static_cast<float>(exact);
        const Site site = classifier.classify(std::span(&receiver, 1));
        const WeightedSite weighted{&site, 1};
        const Rgb light =
            full ? full_gather.irradiance(at, receiver.irradiance) : light_at(shader, at, std::span(&weighted, 1));
        ours += static_cast<double>(luminance(light));
        truth += exact;
        squares += std::pow(static_cast<double>(luminance(light)) - exact, 2);
        ++taken;
    }
    return {ours / truth, std::sqrt(squares / kPoints) / (truth / kPoints)};
}

TEST(GatherOracle, light_at_random_points_is_that_of_dense_rays) {
    for (const bool full : {false, true}) {
        const Agreement room = agreement(lamp_room(0.5F), full), mixed = agreement(mixed_scene(), full);
        EXPECT_NEAR(room.mean, 1, 0.01) << full;
        EXPECT_NEAR(mixed.mean, 1, 0.01) << full;
        EXPECT_LT(room.rms, 0.02) << full;
        EXPECT_LT(mixed.rms, 0.03) << full;
    }
}

}  // namespace
}  // namespace gg::test
