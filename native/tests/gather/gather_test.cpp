// Whole gathers held against exact light, against random walks, and against one another.
#include <gtest/gtest.h>

#include <array>

#include "core/random.h"
#include "oracles/path_irradiance.h"
#include "support/gather_scenes.h"
#include "support/gathered.h"
#include "support/grid_picture.h"
#include "support/law_scenes.h"

namespace gg::test {
namespace {

// Every face emits 1 W/m2 and reflects half: 2 W/m2 fall everywhere.
TEST(FullGatherTest, furnace_is_even) {
    Gathered room(furnace(0.5F, true));
    FullGather gather = room.full();
    float mean = 0;
    for (std::uint32_t wall = 0; wall < 6; ++wall) {
        for (const Vec2 place : {Vec2(0.3F, 0.3F), Vec2(0.1F, 0.7F)}) {
            const float light = luminance(gather.irradiance(fragment_at(room.prepared.scene, wall, 0, place), 2));
            EXPECT_NEAR(light, 2, 0.1F) << wall;  // clusters are 32 points
            mean += light / 12;
        }
    }
    EXPECT_NEAR(mean, 2, 0.04F);
    EXPECT_GT(gather.counts().visibility_rays, 12U * 50);
}

TEST(FullGatherTest, agrees_with_random_walks) {
    Gathered room(lamp_room(0.5F));
    FullGather gather = room.full();
    double ours = 0, truth = 0;
    for (std::uint32_t wall = 0; wall < 6; ++wall) {
        const Fragment at = fragment_at(room.prepared.scene, wall, 1, {0.35F, 0.4F});
        ours += static_cast<double>(gather.irradiance(at, 1).y);  // grey
        constexpr int kWalks = 20000;
        for (std::uint64_t walk = 0; walk < kWalks; ++walk) {
            const oracle::WalkedScene scene{room.prepared.scene, *room.prepared.colors, *room.prepared.tracer};
            truth += oracle::walked_irradiance(scene, at.position, at.normal, hash64(wall, walk)).y / kWalks;
        }
    }
    EXPECT_NEAR(ours / truth, 1, 0.02);
}

// At a site on its own, with nothing interpolated, the models are what the full gather does.
TEST(GridGatherTest, threshold_zero_is_the_full_gather) {
    Gathered room(lamp_room(0.5F));
    FullGather full = room.full();
    Classifier classifier = room.classifier(0);
    Shader shader = room.shader();
    float mean = 0;
    for (std::uint32_t wall = 0; wall < 6; ++wall) {
        const Fragment at = fragment_at(room.prepared.scene, wall, 0, {0.3F, 0.4F});
        const Receiver receiver = receiver_at(*room.solution, at);
        const Site site = classifier.classify(std::span(&receiver, 1));
        const WeightedSite weighted{&site, 1};
        const float expected = luminance(full.irradiance(at, 1));
        const float ratio = luminance(light_at(shader, at, std::span(&weighted, 1))) / expected;
        EXPECT_NEAR(ratio, 1, 0.06F) << wall;  // many senders have one ray
        mean += ratio / 6;
    }
    EXPECT_NEAR(mean, 1, 0.02F);
}

TEST(GridGatherTest, a_higher_threshold_takes_fewer_rays) {
    Gathered room(lamp_room(0.5F));
    const Fragment at = fragment_at(room.prepared.scene, 0, 0, {0.3F, 0.4F});
    const Receiver receiver = receiver_at(*room.solution, at);
    std::uint64_t before = ~0ULL;
    float exact = 0;
    for (const float threshold : {0.0F, 0.003F, 0.01F, 10.0F}) {
        Classifier classifier = room.classifier(threshold);
        Shader shader = room.shader();
        const Site site = classifier.classify(std::span(&receiver, 1));
        const WeightedSite weighted{&site, 1};
        const float light = luminance(light_at(shader, at, std::span(&weighted, 1)));
        exact = threshold == 0 ? light : exact;
        EXPECT_NEAR(light / exact, 1, threshold < 1 ? 0.03F : 0.1F) << threshold;
        EXPECT_LT(shader.counts().visibility_rays, before);
        before = shader.counts().visibility_rays;
    }
    EXPECT_EQ(before, 0U);
}

// Rays that go together say what they say alone.
TEST(GridGatherTest, points_together_have_the_light_they_have_alone) {
    Gathered room(lamp_room(0.5F));
    Classifier classifier = room.classifier(0.003F);
    Shader shader = room.shader();
    std::array<Site, 3> sites;
    std::vector<PlacedFragment> placed;
    for (std::uint32_t k = 0; k < 3; ++k) {
        const Fragment at = fragment_at(room.prepared.scene, k, 0, {0.3F, 0.25F});
        const Receiver receiver = receiver_at(*room.solution, at);
        sites[k] = classifier.classify(std::span(&receiver, 1));
        EXPECT_GT(sites[k].senders.size(), 3U);
    }
    for (std::uint32_t k = 0; k < 6; ++k) {
        const Fragment at = fragment_at(room.prepared.scene, k / 2, 0, {0.3F, 0.2F + 0.1F * static_cast<float>(k % 2)});
        placed.push_back({at, {WeightedSite{&sites[k / 2], 0.75F}, WeightedSite{&sites[2], 0.25F}}, 2});
    }
    std::vector<PointLight> together(placed.size());
    std::vector<PointCounts> taken(placed.size());
    shader.shade(placed, together, taken);
    for (std::size_t k = 0; k < placed.size(); ++k) {
        EXPECT_NEAR(luminance(light_at(shader, placed[k].at, placed[k].sites()) / together[k].all), 1, 1e-5F) << k;
    }
}

// What is known of a whole fragment stands for its part: all of the light is as before, and senders that are not asked
// again take no rays.
TEST(GridGatherTest, soft_light_that_is_known_is_not_worked_out_again) {
    Gathered room(lamp_room(0.5F));
    Classifier classifier = room.classifier(0.003F);
    Shader shader = room.shader();
    for (std::uint32_t wall = 0; wall < 6; ++wall) {
        const Fragment at = fragment_at(room.prepared.scene, wall, 0, {0.3F, 0.4F});
        const Receiver receiver = receiver_at(*room.solution, at);
        const Site site = classifier.classify(std::span(&receiver, 1));
        PlacedFragment placed{at, {WeightedSite{&site, 1}}, 1};
        const auto shade = [&](PointCounts& taken) {
            PointLight light;
            shader.shade(std::span(&placed, 1), std::span(&light, 1), std::span(&taken, 1));
            return light;
        };
        PointCounts whole_took, part_took;
        const PointLight whole = shade(whole_took);
        EXPECT_GT(luminance(whole.soft), 0.02F * luminance(whole.all)) << wall;
        placed.known.soft = 3.0F * whole.soft;
        const PointLight part = shade(part_took);
        EXPECT_NEAR(luminance(part.all), luminance(whole.all + 2.0F * whole.soft), 1e-4F) << wall;
        EXPECT_EQ(part.soft, *placed.known.soft) << wall;
        EXPECT_LT(part_took.visibility_rays, 0.7F * static_cast<float>(whole_took.visibility_rays)) << wall;
    }
}

// The same of senders that glow: what the point saw of them itself brings the same light, without their rays.
TEST(GridGatherTest, visibility_that_is_known_is_not_looked_at_again) {
    Gathered room(lamp_room(0.5F));
    Classifier classifier = room.classifier(0.003F);
    Shader shader = room.shader();
    for (std::uint32_t wall = 0; wall < 5; ++wall) {  // all but the ceiling, in which the lamp is
        const Fragment at = fragment_at(room.prepared.scene, wall, 0, {0.3F, 0.4F});
        const Receiver receiver = receiver_at(*room.solution, at);
        const Site site = classifier.classify(std::span(&receiver, 1));
        PlacedFragment placed{at, {WeightedSite{&site, 1}}, 1};
        std::array<PointCounts, 2> taken;
        std::array<PointLight, 2> light;
        shader.shade(std::span(&placed, 1), std::span(&light[0], 1), std::span(&taken[0], 1));
        ASSERT_FALSE(light[0].glowing.empty()) << wall;
        placed.known.soft = light[0].soft;
        placed.known.glowing = light[0].glowing;
        shader.shade(std::span(&placed, 1), std::span(&light[1], 1), std::span(&taken[1], 1));
        EXPECT_NEAR(luminance(light[1].all / light[0].all), 1, 1e-5F) << wall;
        EXPECT_EQ(taken[1].visibility_rays, 0U) << wall;
        placed.known.glowing.clear();
        shader.shade(std::span(&placed, 1), std::span(&light[1], 1), std::span(&taken[1], 1));
        EXPECT_GT(taken[1].visibility_rays, 0U) << wall;
    }
}

// The same of the sky.
TEST(GridGatherTest, sky_that_is_known_is_not_looked_at_again) {
    const ViewedScene scene = viewed_window_room();
    const GridPicture picture(scene.description, scene.camera, {});
    Shader shader = picture.shader();
    std::size_t lit = 0;
    for (const Fragment& at : picture.some_fragments(40)) {
        PlacedFragment placed = picture.place(at);
        std::array<PointCounts, 2> taken;
        std::array<PointLight, 2> light;
        shader.shade(std::span(&placed, 1), std::span(&light[0], 1), std::span(&taken[0], 1));
        if (light[0].sky == Rgb(0.0F)) {
            continue;
        }
        ++lit;
        placed.known.sky = 3.0F * light[0].sky;
        shader.shade(std::span(&placed, 1), std::span(&light[1], 1), std::span(&taken[1], 1));
        EXPECT_NEAR(luminance(light[1].all / (light[0].all + 2.0F * light[0].sky)), 1, 1e-5F);
        EXPECT_LT(taken[1].visibility_rays, taken[0].visibility_rays);
    }
    EXPECT_GT(lit, 10U);
}

// From one site to another: both ends are the sites' own models, and no step is a jump.
TEST(GridGatherTest, blends_are_continuous) {
    Gathered room(lamp_room(0.5F));
    Classifier classifier = room.classifier(0.01F);
    Shader shader = room.shader();
    std::array<Site, 2> sites;
    for (int k = 0; k < 2; ++k) {
        const Fragment at = fragment_at(room.prepared.scene, 4, 0, {0.2F + 0.3F * static_cast<float>(k), 0.2F});
        const Receiver receiver = receiver_at(*room.solution, at);
        sites[k] = classifier.classify(std::span(&receiver, 1));
    }
    constexpr int kSteps = 1000;
    float before = 0, largest = 0, mean = 0;
    for (int i = 0; i <= kSteps; ++i) {
        const float t = static_cast<float>(i) / kSteps;
        const Fragment at = fragment_at(room.prepared.scene, 4, 0, {0.2F + 0.3F * t, 0.2F});
        const std::array<WeightedSite, 2> around{WeightedSite{&sites[0], 1 - t}, WeightedSite{&sites[1], t}};
        const float now = luminance(light_at(shader, at, around));
        largest = i > 0 ? std::max(largest, std::abs(now - before)) : 0;
        before = now;
        mean += now / kSteps;
    }
    EXPECT_LT(largest, 0.05F * mean);  // a few rays out of a hundred that meet an edge at once
}

// One site for a stretch of floor from below the cube, in its shadow, out into the light.
TEST(GridGatherTest, one_site_knows_a_shadow_that_falls_across_it) {
    Gathered room(lamp_room(0.5F));
    FullGather full = room.full();
    Classifier classifier = room.classifier(0.014F);
    Shader shader = room.shader();
    std::vector<Fragment> points;
    std::vector<Receiver> receivers;
    for (int k = 0; k < 24; ++k) {
        points.push_back(fragment_at(room.prepared.scene, 4, 0, {0.03F + 0.025F * static_cast<float>(k), 0.3F}));
        receivers.push_back(receiver_at(*room.solution, points.back()));
    }
    const Site site = classifier.classify(receivers);
    const WeightedSite weighted{&site, 1};
    float least = kInfinity, most = 0, worst = 0, mean = 0;
    for (const Fragment& at : points) {
        const float expected = luminance(full.irradiance(at, 1));
        const float found = luminance(light_at(shader, at, std::span(&weighted, 1)));
        least = std::min(least, expected);
        most = std::max(most, expected);
        worst = std::max(worst, std::abs(found / expected - 1));
        mean += (found - expected) / expected / 24;
    }
    EXPECT_LT(least, 0.7F * most);
    EXPECT_LT(worst, 0.1F);
    EXPECT_LT(std::abs(mean), 0.03F);
}

}  // namespace
}  // namespace gg::test
