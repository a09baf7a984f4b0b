// Shadow rays to sources, and the choice among sources.
#include "radiosity/source_rays.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "radiosity/source_guide.h"
#include "support/opened_clusters.h"
#include "transport/emitter_sampling.h"
#include "transport/form_factor.h"

namespace gg::test {
namespace {

// Mean light of the rays that are not blocked.
double mean_light(const Prepared& prepared, const Hierarchy& hierarchy, NodeId source, const OffsetPoint& x) {
    constexpr std::uint32_t kCount = 20000;
    const Sequence4 sequence(3);
    double sum = 0;
    for (std::uint32_t k = 0; k < kCount; ++k) {
        const SourceRay ray = ray_to_source(hierarchy, source, x, Vec3(sequence(k, 0), sequence(k, 1), sequence(k, 2)));
        if (luminance(ray.light) > 0 && !prepared.tracer->occluded(ray.ray, RayMask::kLight)) {
            sum += luminance(ray.light) / kCount;
        }
    }
    return sum;
}

// A square lamp of 1 m at a height of 2 m above a floor, half of it hidden by a screen.
SceneDescription screened_lamp(float screen_height) {
    SceneBuilder builder;
    const auto grey = builder.material(Rgb(0.5F));
    builder.quad({-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}, grey, "floor");
    builder.quad({-5, -5, screen_height}, {0, -5, screen_height}, {0, 5, screen_height}, {-5, 5, screen_height}, grey,
                 "screen");
    builder.area_light({0, 0, 2}, {0, 0, -1}, 1, Rgb(100));
    return builder.description;
}

NodeId first_lamp(const Hierarchy& hierarchy) {
    return hierarchy.infinite_and_lamps().front();
}

TEST(SourceRays, an_open_lamp_brings_its_irradiance) {
    Prepared prepared(screened_lamp(3));
    const Hierarchy hierarchy(prepared.scene, *prepared.colors, prepared.faces());
    for (const Vec3 x : {Vec3(0, 0, 0.01F), Vec3(0.4F, 0.3F, 1.8F), Vec3(3, 2, 0.01F), Vec3(4.5F, -4.5F, 0.5F)}) {
        const OffsetPoint point{x, Vec3(0, 0, 1)};
        const double exact = luminance(lamp_irradiance(prepared.scene.lamps[0], x, point.normal));
        EXPECT_NEAR(mean_light(prepared, hierarchy, first_lamp(hierarchy), point) / exact, 1, 0.01)
            << x.x << " " << x.z;
    }
}

// On the edge of the screen half of the lamp is seen.
TEST(SourceRays, a_half_hidden_lamp_brings_half) {
    Prepared prepared(screened_lamp(1));
    const Hierarchy hierarchy(prepared.scene, *prepared.colors, prepared.faces());
    for (const float height : {0.01F, 0.9F}) {
        const OffsetPoint point{{0, 0, height}, Vec3(0, 0, 1)};
        const double exact = luminance(lamp_irradiance(prepared.scene.lamps[0], point.position, point.normal));
        EXPECT_NEAR(mean_light(prepared, hierarchy, first_lamp(hierarchy), point) / exact, 0.5, 0.02) << height;
    }
}

// Right beside a lamp, where the part that is nearest brings nearly all, and is hidden.
TEST(SourceRays, hidden_near_part_of_a_lamp_is_not_made_up_for_by_the_rest) {
    SceneBuilder builder;
    const auto grey = builder.material(Rgb(0.5F));
    builder.quad({0.6F, -5, 1}, {0.6F, 5, 1}, {0.6F, 5, 3}, {0.6F, -5, 3}, grey, "wall beside");
    builder.quad({0.52F, -5, 1.86F}, {0.52F, 5, 1.86F}, {0.52F, 5, 1.99F}, {0.52F, -5, 1.99F}, grey, "screen");
    builder.area_light({0, 0, 2}, {0, 0, -1}, 1, Rgb(100));
    Prepared prepared(builder.description);
    const Hierarchy hierarchy(prepared.scene, *prepared.colors, prepared.faces());
    const OffsetPoint point{{0.599F, 0.1F, 1.8F}, Vec3(-1, 0, 0)};
    double truth = 0;  // uniform points on the lamp
    constexpr std::uint32_t kCount = 200000;
    const Sequence4 sequence(11);
    for (std::uint32_t k = 0; k < kCount; ++k) {
        const LampSample s = sample_lamp(prepared.scene.lamps[0], point.position, sequence(k, 0), sequence(k, 1));
        const Ray ray{point.position, s.direction, 0, 0.9999F * s.distance};
        if (!prepared.tracer->occluded(ray, RayMask::kLight)) {
            truth += luminance(s.normal_irradiance) * std::max(0.0F, dot(point.normal, s.direction)) / kCount;
        }
    }
    ASSERT_GT(truth, 0);
    EXPECT_NEAR(mean_light(prepared, hierarchy, first_lamp(hierarchy), point) / truth, 1, 0.1);
}

TEST(SourceRays, the_whole_sky_brings_pi) {
    SceneBuilder builder;
    builder.description.world = Rgb(1.0F);
    builder.quad({-1, -1, -9}, {1, -1, -9}, {1, 1, -9}, {-1, 1, -9}, builder.material(Rgb(0.5F)));
    Prepared prepared(builder.description);
    const Hierarchy hierarchy(prepared.scene, *prepared.colors, prepared.faces());
    double sum = 0;
    for (const NodeId cell : hierarchy.infinite_and_lamps()) {
        sum += mean_light(prepared, hierarchy, cell, {{0, 0, 0}, {0, 0, 1}});
    }
    EXPECT_NEAR(sum, kPi, 0.01);
}

TEST(SourceRays, a_glowing_element_brings_its_form_factor) {
    SceneBuilder builder;
    builder.quad({0, 0, 1}, {0, 9, 1}, {9, 9, 1}, {9, 0, 1}, builder.material(Rgb(0.5F), Rgb(2.0F)));
    builder.quad({0, 0, -90}, {0, 90, -90}, {90, 90, -90}, {90, 0, -90}, builder.material(Rgb(0.5F)));
    Prepared prepared(builder.description);
    Hierarchy hierarchy(prepared.scene, *prepared.colors, prepared.faces());
    open_clusters(hierarchy, prepared.control);
    const SourceGuide guide(hierarchy, {});
    const OffsetPoint x{{0.2F, 0.2F, 0}, {0, 0, 1}};
    double sum = 0, exact = 0, behind = 0, facing_away = 0;
    const Sequence4 sequence(5);
    for (const NodeId emitter : guide.emitters()) {
        const Node& node = hierarchy[emitter];
        if (node.normal.z > 0) {
            continue;
        }
        const auto& c = node.corner;
        exact += 2 * kPi * point_to_triangle(x.position, x.normal, c[0], c[1], c[2]);
        constexpr std::uint32_t kCount = 4000;
        for (std::uint32_t k = 0; k < kCount; ++k) {
            const Vec3 sample(sequence(k, 0), sequence(k, 1), sequence(k, 2));
            sum += ray_to_source(hierarchy, emitter, x, sample).light.x / kCount;
            facing_away += ray_to_source(hierarchy, emitter, {x.position, -x.normal}, sample).light.x;
            behind += ray_to_source(hierarchy, emitter, {{0.2F, 0.2F, 2}, -x.normal}, sample).light.x;
        }
    }
    ASSERT_GT(exact, 0);
    EXPECT_NEAR(sum / exact, 1, 0.02);
    EXPECT_EQ(behind, 0);
    EXPECT_EQ(facing_away, 0);
}

// Every direction above a tilted receiver's horizon has a chance, from cells of any size.
TEST(SourceGuide, no_part_of_the_sky_is_left_out) {
    SceneBuilder builder;
    builder.description.world = Rgb(1.0F);
    const auto grey = builder.material(Rgb(0.5F));
    builder.quad({-9, -9, 1}, {9, -9, 1}, {9, 9, 1}, {-9, 9, 1}, grey, "roof");
    builder.quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, grey, "floor");
    Prepared prepared(builder.description);
    const auto solution = prepared.solve(0.01F);
    const SourceGuide guide(solution->hierarchy, solution->links.all);
    NodeId floor = kNone;
    for (NodeId id = 0; id < solution->hierarchy.nodes().size(); ++id) {
        const Node& node = solution->hierarchy[id];
        if (node.kind == NodeKind::kElement && node.child_count == 0 && node.instance == 1 && !node.back) {
            floor = id;
        }
    }
    ASSERT_NE(floor, kNone);
    Sources sources;
    guide.list({{0, 0, 0}, normalize(Vec3(1, 0.3F, 0.2F)), 0.1F, floor}, sources);
    ASSERT_TRUE(sources.has(kSkySources));
    const Sequence4 sequence(1);
    for (std::uint32_t k = 0; k < 20000; ++k) {
        const Vec3 direction = square_to_sphere(sequence(k, 0), sequence(k, 1));
        if (dot(direction, normalize(Vec3(1, 0.3F, 0.2F))) < 0) {
            continue;
        }
        bool found = false;
        for (std::size_t i = sources.begin[kSkySources]; i < sources.begin[kSkySources + 1]; ++i) {
            const Node& cell = solution->hierarchy[sources.nodes[i]];
            // The nearest direction of a grid on the cell.
            for (int p = 0; p <= 16 && !found; ++p) {
                for (int q = 0; q <= 16 && !found; ++q) {
                    const Vec3 d =
                        cell_direction(sky_cell_of(cell), static_cast<float>(p) / 16, static_cast<float>(q) / 16);
                    found = dot(d, direction) > 1 - 0.002F * cell.area;
                }
            }
        }
        EXPECT_TRUE(found) << direction.x << " " << direction.y << " " << direction.z;
        if (!found) {
            break;
        }
    }
}

// Two lamps, one of which a wall hides from the floor.
TEST(SourceGuide, hidden_sources_keep_a_chance_and_those_behind_have_none) {
    SceneBuilder builder;
    const auto grey = builder.material(Rgb(0.5F));
    builder.quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, grey, "floor");
    builder.quad({-9, -9, 2}, {9, -9, 2}, {9, 9, 2}, {-9, 9, 2}, grey, "ceiling");
    builder.area_light({0, 0, 1.5F}, {0, 0, -1}, 0.2F, Rgb(10), "seen");
    builder.area_light({0, 0, 3}, {0, 0, -1}, 0.2F, Rgb(1000), "hidden");
    builder.area_light({0, 0, -1}, {0, 0, 1}, 0.2F, Rgb(1000), "below");
    Prepared prepared(builder.description);
    const auto solution = prepared.solve();
    const SourceGuide guide(solution->hierarchy, solution->links.all);
    Sources sources;
    for (NodeId id = 0; id < solution->hierarchy.nodes().size(); ++id) {
        const Node& node = solution->hierarchy[id];
        if (node.kind == NodeKind::kElement && node.child_count == 0 && node.instance == 0 && !node.back) {
            guide.list({node.center, node.normal, node.radius, id}, sources);
            ASSERT_EQ(sources.begin[1] - sources.begin[0], 2U);
            EXPECT_FALSE(sources.has(kSkySources));
            EXPECT_GT(sources.sums[0], 0);
            EXPECT_GT(sources.sums[1], sources.sums[0]);
        }
    }
}

}  // namespace
}  // namespace gg::test
