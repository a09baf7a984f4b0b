#include "trace/ray_tracer.h"

#include <gtest/gtest.h>

#include "core/control.h"
#include "core/parallel.h"
#include "gridgather.h"
#include "soup.h"

namespace gg {
namespace {

using test::add_instance;
using test::brute_force_hit;
using test::Dice;
using test::make_soup;
using test::TrueHit;

Affine make_affine(Vec3 x, Vec3 y, Vec3 z, Vec3 translation) {
    return {Mat3(x, y, z), translation};
}

constexpr std::uint32_t kFlattened = 4;

// A mesh used once, one used plainly, mirrored, sheared and flattened, a tiny one used twice, hidden ones.
Scene mixed_scene() {
    Scene scene;
    scene.meshes = {make_soup(1, 300, 0.3F), make_soup(2, 200, 0.3F), make_soup(3, 5, 0.8F)};
    add_instance(scene, 0, make_affine({1, 0.2F, 0}, {0, 1, 0}, {0.1F, 0, 1}, {0, 0, 0}));
    add_instance(scene, 1, Affine{Mat3(1), {2, 0, 0}});
    add_instance(scene, 1, make_affine({-1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-2, 0, 0}));
    add_instance(scene, 1, make_affine({1, 0.5F, 0}, {0.7F, 1, 0}, {0, 0.3F, 2}, {0, 2, 0}));
    add_instance(scene, 1, make_affine({1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 0, -1.5F}));
    add_instance(scene, 2, Affine{Mat3(0.5F), {0, -2, 0}});
    add_instance(scene, 2, Affine{Mat3(0.5F), {0, -2.5F, 1}});
    add_instance(scene, 1, Affine{Mat3(1), {0, 0, 2}}, GG_HIDDEN_FROM_CAMERA);
    add_instance(scene, 2, Affine{Mat3(1), {0, 0, 2}}, GG_HIDDEN_FROM_LIGHT);
    return scene;
}

std::vector<Ray> random_rays(std::uint64_t seed, std::size_t count) {
    Dice dice(seed);
    std::vector<Ray> rays;
    for (std::size_t index = 0; index < count; ++index) {
        const Vec3 origin = 4.0F * dice.vector();
        const Vec3 target = 2.0F * dice.vector();
        const float scale = 1.5F + dice.number();
        const float near = index % 4 == 0 ? 0.7F / scale : 0;
        rays.push_back({origin, (target - origin) * scale, near, index % 3 == 0 ? 0.9F / scale : kInfinity});
    }
    return rays;
}

class RayTracerTest : public ::testing::TestWithParam<RayMask> {
  protected:
    Scene scene_ = mixed_scene();
    Control control_;
    RayTracer tracer_{scene_, control_};
    RayMask mask_ = GetParam();
    std::uint32_t hidden_ = mask_ == RayMask::kCamera ? GG_HIDDEN_FROM_CAMERA : GG_HIDDEN_FROM_LIGHT;
};

TEST_P(RayTracerTest, closest_hit_equals_brute_force) {
    int hits = 0;
    int doubtful = 0;
    for (const Ray& ray : random_rays(7, 4000)) {
        const TrueHit expected = brute_force_hit(scene_, ray, hidden_);
        if (expected.doubtful) {
            ++doubtful;
            continue;
        }
        const Hit hit = tracer_.closest_hit(ray, mask_);
        ASSERT_EQ(hit.instance, expected.instance);
        ASSERT_EQ(tracer_.occluded(ray, mask_), expected.instance != kNone);
        if (expected.instance == kNone) {
            EXPECT_TRUE(hit.missed());
            continue;
        }
        ++hits;
        EXPECT_EQ(hit.triangle, expected.triangle);
        EXPECT_NEAR(hit.distance, expected.distance, 1e-4);
        EXPECT_NEAR(hit.u, expected.u, 2e-3);
        EXPECT_NEAR(hit.v, expected.v, 2e-3);
    }
    EXPECT_GT(hits, 1500);
    EXPECT_LT(doubtful, 600);
}

TEST_P(RayTracerTest, packets_equal_single_rays) {
    const std::vector<Ray> rays = random_rays(8, 1000 + 5);  // a remainder that fills no packet
    for (const Coherence coherence : {Coherence::kIncoherent, Coherence::kCoherent}) {
        std::vector<Hit> hits(rays.size());
        std::vector<std::uint8_t> occlusion(rays.size(), 7);
        tracer_.closest_hits(rays, hits, mask_, coherence);
        tracer_.occluded(rays, occlusion, mask_, coherence);
        for (std::size_t index = 0; index < rays.size(); ++index) {
            const Hit single = tracer_.closest_hit(rays[index], mask_);
            ASSERT_EQ(hits[index].instance, single.instance);
            if (single.instance != kFlattened) {  // its triangles lie in one plane and overlap
                ASSERT_EQ(hits[index].triangle, single.triangle);
            }
            ASSERT_EQ(occlusion[index], tracer_.occluded(rays[index], mask_) ? 1 : 0);
            if (!single.missed()) {
                ASSERT_NEAR(hits[index].distance, single.distance, 1e-5 * (1 + single.distance));
            }
        }
    }
}

TEST_P(RayTracerTest, occluded_exactly_when_closest_hit_lies_in_range) {
    int blocked = 0;
    for (Ray ray : random_rays(9, 2000)) {
        const Hit hit = tracer_.closest_hit(ray, mask_);
        if (hit.missed()) {
            continue;
        }
        ray.far = hit.distance * 1.001F;
        blocked += tracer_.occluded(ray, mask_) ? 1 : 0;
        ray.far = hit.distance * 0.999F;
        ASSERT_FALSE(tracer_.occluded(ray, mask_));
        ray.near = ray.far;
        ray.far = hit.distance * 1.001F;
        ASSERT_TRUE(tracer_.occluded(ray, mask_));
    }
    EXPECT_GT(blocked, 500);
}

INSTANTIATE_TEST_SUITE_P(masks, RayTracerTest, ::testing::Values(RayMask::kCamera, RayMask::kLight));

Scene wall() {
    Scene scene;
    Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    scene.meshes = {mesh};
    add_instance(scene, 0, {});
    return scene;
}

TEST(ray_tracer, degenerate_rays_meet_nothing) {
    const Scene scene = wall();
    const Control control;
    const RayTracer tracer(scene, control);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<Ray> rays = {{{0, 0, 1}, {0, 0, 0}},           {{0, 0, nan}, {0, 0, -1}},
                                   {{0, 0, 1}, {nan, 0, -1}},        {{0, 0, kInfinity}, {0, 0, -1}},
                                   {{0, 0, 1}, {0, 0, -1}, 2, 0.5F}, {{0, 0, 1}, {0, 0, -1}, nan, kInfinity},
                                   {{0, 0, 1}, {0, 0, -1}, 0, nan},  {{0, 0, 1}, {0, 0, -1}, 0, -1}};
    std::vector<Hit> hits(rays.size());
    std::vector<std::uint8_t> results(rays.size());
    tracer.closest_hits(rays, hits, RayMask::kLight, Coherence::kCoherent);
    tracer.occluded(rays, results, RayMask::kLight, Coherence::kCoherent);
    for (std::size_t index = 0; index < rays.size(); ++index) {
        EXPECT_TRUE(tracer.closest_hit(rays[index], RayMask::kLight).missed()) << index;
        EXPECT_FALSE(tracer.occluded(rays[index], RayMask::kLight)) << index;
        EXPECT_TRUE(hits[index].missed()) << index;
        EXPECT_EQ(results[index], 0) << index;
    }
    EXPECT_TRUE(tracer.occluded({{0, 0, 1}, {0, 0, -1}, -5, 1.5F}, RayMask::kLight));
}

TEST(ray_tracer, no_ray_slips_through_a_shared_edge) {
    const Scene scene = wall();
    const Control control;
    const RayTracer tracer(scene, control);
    Dice dice(4);
    for (int count = 0; count < 20000; ++count) {
        const float along = dice.number();
        const Vec3 origin = 3.0F * dice.vector() + Vec3(0, 0, 4);
        EXPECT_TRUE(tracer.occluded({origin, Vec3(along, along, 0) - origin}, RayMask::kLight));
    }
}

TEST(ray_tracer, an_empty_scene_occludes_nothing) {
    const Scene scene;
    const Control control;
    const RayTracer tracer(scene, control);
    EXPECT_FALSE(tracer.occluded({{0, 0, 1}, {0, 0, -1}}, RayMask::kLight));
    EXPECT_TRUE(tracer.closest_hit({{0, 0, 1}, {0, 0, -1}}, RayMask::kCamera).missed());
}

TEST(ray_tracer, memory_is_counted) {
    Scene scene;
    scene.meshes = {make_soup(1, 20000, 0.1F)};
    add_instance(scene, 0, {});
    const Control control;
    const RayTracer tracer(scene, control);
    EXPECT_GT(tracer.bytes(), 20000U * 3 * sizeof(Vec3));
    EXPECT_LT(tracer.bytes(), 20000U * 1000);
}

TEST(ray_tracer, a_cancelled_build_throws_cancelled) {
    Scene scene;
    scene.meshes = {make_soup(1, 100, 0.1F)};
    add_instance(scene, 0, {});
    Control control;
    control.cancel();
    EXPECT_THROW(RayTracer(scene, control), Cancelled);
}

TEST(ray_tracer, a_build_on_one_thread_gives_the_same_hits) {
    const Scene scene = mixed_scene();
    const Control control;
    const std::vector<Ray> rays = random_rays(10, 500);
    std::vector<Hit> expected(rays.size());
    RayTracer(scene, control).closest_hits(rays, expected, RayMask::kLight, Coherence::kIncoherent);
    run_with_threads(1, [&] {
        std::vector<Hit> hits(rays.size());
        RayTracer(scene, control).closest_hits(rays, hits, RayMask::kLight, Coherence::kIncoherent);
        for (std::size_t index = 0; index < rays.size(); ++index) {
            EXPECT_EQ(hits[index].instance, expected[index].instance);
            EXPECT_EQ(hits[index].triangle, expected[index].triangle);
            EXPECT_EQ(hits[index].distance, expected[index].distance);
        }
    });
}

}  // namespace
}  // namespace gg
