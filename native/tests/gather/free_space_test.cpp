// Sites as published: rays that pass one object, and closed rooms.
#include "gather/free_space.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "gather/shade.h"
#include "support/law_scenes.h"

namespace gg::test {
namespace {

// The room has a cube, x 1..1.7, y 1..1.8, z 0.2..0.9, which is lit from outside alone; its walls are from both sides.
bool is_blocked(Vec3 from, Vec3 to) {
    static const Prepared prepared(lamp_room(0.5F));
    HitCounter counter(prepared.scene, *prepared.tracer);
    const std::vector<Ray> rays(3, {from, to - from, 0, 1});
    std::vector<std::uint8_t> blocked;
    counter.count(rays, blocked);
    EXPECT_EQ(blocked.size(), 3U);
    EXPECT_EQ(blocked[0], blocked[2]);
    return blocked[0] != 0;
}

TEST(HitCounter, a_ray_may_pass_one_object) {
    EXPECT_FALSE(is_blocked({0.5F, 0.5F, 2}, {3.5F, 0.5F, 2}));         // nothing
    EXPECT_FALSE(is_blocked({0.5F, 1.4F, 0.5F}, {2, 1.4F, 0.5F}));      // all of the cube: it is the receiver
    EXPECT_FALSE(is_blocked({1.2F, 1.4F, 0.5F}, {2, 1.4F, 0.5F}));      // from within it
    EXPECT_FALSE(is_blocked({-0.5F, 0.5F, 2}, {2, 0.5F, 2}));           // a wall, from behind
    EXPECT_TRUE(is_blocked({-0.5F, 1.4F, 0.5F}, {2, 1.4F, 0.5F}));      // a wall and the cube
    EXPECT_TRUE(is_blocked({0.5F, 1.4F, 0.55F}, {3.9F, 1.4F, 0.75F}));  // the cube and the sphere
    EXPECT_TRUE(is_blocked({1.2F, 1.4F, 0.55F}, {3.9F, 1.4F, 0.75F}));  // the same from within the cube
}

// A furnace around a vertex, and what a plane there receives.
struct Space {
    Prepared prepared;
    std::shared_ptr<const Solution> solution = prepared.solve();
    ClusterPoints cluster_points{*solution, prepared.control};
    NodeOrder order{hierarchy_of(*solution)};

    explicit Space(bool furnished) : prepared(furnace(0.5F, furnished)) {}

    Site site_at(Vec3 vertex, const Receiver& receiver, float threshold) {
        const Sequence4 sequence(4);
        std::vector<Vec3> points;
        for (std::uint32_t i = 0; i < FreeSpaceClassifier::kMostPoints; ++i) {
            points.push_back(vertex + 0.1F * Vec3(sequence(i, 0) - 0.5F, sequence(i, 1) - 0.5F, sequence(i, 2) - 0.5F));
        }
        FreeSpaceClassifier classifier(*solution, order, cluster_points, *prepared.tracer, {256, threshold, 0});
        return classifier.classify({vertex, points, std::span(&receiver, 1)});
    }

    float light(const Site& site, Vec3 position, Vec3 normal) {
        PlacedFragment placed;
        placed.at.position = position;
        placed.at.normal = placed.at.shading_normal = normal;
        placed.at.share = 1;
        placed.around[0] = {&site, 1};
        placed.count = 1;
        Shader shader(*solution, order, cluster_points, *prepared.tracer);
        PointLight light;
        PointCounts taken;
        shader.shade(std::span(&placed, 1), std::span(&light, 1), std::span(&taken, 1));
        EXPECT_EQ(taken.senders, site.senders.size());
        return luminance(light.all);
    }
};

// 2 W/m2 come from everywhere, whichever senders are interpolated and whichever are not.
TEST(FreeSpaceClassifierTest, a_furnace_is_even) {
    Space space(false);
    const Vec3 below(1.5F, 1.2F, 1e-4F), up(0, 0, 1);
    const NodeId place = place_at(*space.solution, 4, 0, false, below);
    ASSERT_NE(place, kNone);
    std::size_t resampled = 0;
    for (const float threshold : {10.0F, 0.014F, 0.0F}) {
        const Site site = space.site_at({1.5F, 1.2F, 0.2F}, {below, up, up, place, 0.5F, 2}, threshold);
        EXPECT_GE(site.senders.size(), resampled);
        resampled = site.senders.size();
        EXPECT_EQ(threshold > 1, resampled == 0);
        // Interpolated walls are beams, of which the horizon cuts off nothing.
        EXPECT_NEAR(space.light(site, below, up), 2, threshold > 1 ? 0.25F : 0.06F) << threshold;
    }
}

// Just above the sphere, which is a cluster that no link tells of: a plane that faces it has sin^2 of its radius in
// angle from it. What is behind it counts as seen, for it may be the receiver.
TEST(FreeSpaceClassifierTest, the_cluster_around_a_vertex_comes_by_rays) {
    Space space(true);
    const Vec3 top(2.8F, 1.4F, 1.301F), up(0, 0, 1), vertex(2.8F, 1.4F, 1.35F);
    const Hit hit = space.prepared.tracer->closest_hit({vertex, -up, 0, 1}, RayMask::kLight);
    ASSERT_EQ(hit.instance, 7U);
    const NodeId place = place_at(*space.solution, hit.instance, hit.triangle, false, top);
    ASSERT_NE(place, kNone);
    const Site site = space.site_at(vertex, {top, up, up, place, 0.5F, 2}, 10);
    const float sine = 0.5F / 0.55F;
    EXPECT_NEAR(luminance(light_of(site.table, TableCosines(-up))), 2 * sine * sine, 0.15F);
    EXPECT_NEAR(space.light(site, top, up), 2, 0.3F);
}

}  // namespace
}  // namespace gg::test
