// Light that is pushed down and radiosity that is pulled up keep their power at every level.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "core/random.h"
#include "support/law_scenes.h"
#include "support/solution_measures.h"

namespace gg::test {
namespace {

TEST(PushPull, power_of_a_parent_is_that_of_its_children) {
    Prepared prepared(mixed_scene());
    const auto solution = prepared.solve(0.04F);
    const auto& nodes = solution->hierarchy.nodes();
    const Lighting& lighting = solution->lighting;
    std::size_t elements = 0, clusters = 0;
    for (NodeId id = 0; id < nodes.size(); ++id) {
        if (!is_surface(nodes[id]) || nodes[id].child_count == 0) {
            continue;
        }
        Vec3d emitted(0.0), arriving(0.0);
        double area = 0;
        for (NodeId child = nodes[id].first_child; child < nodes[id].first_child + nodes[id].child_count; ++child) {
            emitted += lighting.area(child) * Vec3d(lighting.radiosity(child));
            arriving += lighting.area(child) * Vec3d(lighting.irradiance(child));
            area += lighting.area(child);
        }
        ASSERT_NEAR(lighting.area(id) / area, 1, 1e-9);
        for (int channel = 0; channel < 3; ++channel) {
            ASSERT_NEAR(area * lighting.radiosity(id)[channel], emitted[channel], 1e-6 * emitted[channel]) << id;
            ASSERT_NEAR(area * lighting.irradiance(id)[channel], arriving[channel], 1e-6 * arriving[channel]) << id;
        }
        ++(is_cluster(nodes[id]) ? clusters : elements);
    }
    EXPECT_GT(elements, 200U);
    EXPECT_GT(clusters, 20U);
}

TEST(PushPull, irradiance_that_is_set_keeps_its_course_and_reaches_the_root) {
    Prepared prepared(mixed_scene());
    const auto solution = std::const_pointer_cast<Solution>(prepared.solve(0.04F));
    Lighting& lighting = solution->lighting;
    const auto& nodes = solution->hierarchy.nodes();
    std::size_t uneven = 0;
    for (NodeId id = 0; id < nodes.size(); ++id) {
        if (nodes[id].kind != NodeKind::kElement || nodes[id].child_count > 0 ||
            !(luminance(lighting.irradiance(id)) > 1e-3F)) {
            continue;
        }
        const std::array<Rgb, 3> before = lighting.corner_irradiance(id);
        const Rgb mean = lighting.irradiance(id);
        lighting.set_irradiance(id, 3.0F * mean);
        for (int k = 0; k < 3; ++k) {
            ASSERT_NEAR(lighting.corner_irradiance(id)[k].x, 3 * before[k].x, 1e-4F * mean.x);
            uneven += std::abs(before[k].x - mean.x) > 0.01F * mean.x;
        }
    }
    EXPECT_GT(uneven, 100U);
    double arriving = 0;
    lighting.pull(prepared.control);
    for (const NodeId leaf : surface_leaves(*solution)) {
        arriving += lighting.area(leaf) * luminance(lighting.irradiance(leaf));
    }
    EXPECT_NEAR(lighting.area(kGeometryRoot) * luminance(lighting.irradiance(kGeometryRoot)) / arriving, 1, 1e-4);
}

TEST(PushPull, intensity_of_a_cluster_is_the_sum_of_its_parts) {
    Prepared prepared(mixed_scene());
    const auto solution = prepared.solve(0.04F);
    const auto& nodes = solution->hierarchy.nodes();
    const Lighting& lighting = solution->lighting;
    for (NodeId id = 0; id < nodes.size(); ++id) {
        if (!is_cluster(nodes[id]) || nodes[id].child_count == 0) {
            continue;
        }
        DirectionalForm sum;
        for (NodeId child = nodes[id].first_child; child < nodes[id].first_child + nodes[id].child_count; ++child) {
            if (is_cluster(nodes[child])) {
                sum += lighting.intensity(child);
            } else {
                add_face(sum, lighting.radiosity(child) * nodes[child].area / kPi, nodes[child].normal);
            }
        }
        const Sequence4 sequence(id);
        for (std::uint32_t i = 0; i < 8; ++i) {
            const Vec3 direction = square_to_sphere(sequence(i, 0), sequence(i, 1));
            const Rgb whole = evaluate(lighting.intensity(id), direction), parts = evaluate(sum, direction);
            for (int channel = 0; channel < 3; ++channel) {
                const double size = lighting.area(id) * lighting.radiosity(id)[channel];
                ASSERT_NEAR(whole[channel], parts[channel], 1e-5 * size) << id;
            }
        }
    }
}

// A leaf cluster sends out, over all directions, what its faces emit and reflect: the mean of its form is exact.
TEST(PushPull, intensity_of_a_leaf_cluster_carries_its_power) {
    Prepared prepared(mixed_scene());
    const auto solution = prepared.solve(0.08F);
    const Lighting& lighting = solution->lighting;
    std::size_t clusters = 0;
    for (const NodeId id : surface_leaves(*solution)) {
        if (!is_cluster(solution->hierarchy[id])) {
            continue;
        }
        const auto& c = lighting.intensity(id).coefficients;
        const Vec3d power = 4.0 * kPi * (Vec3d(c[0]) + (Vec3d(c[4]) + Vec3d(c[5]) + Vec3d(c[6])) / 3.0);
        const Vec3d expected = lighting.area(id) * Vec3d(lighting.radiosity(id));
        for (int channel = 0; channel < 3; ++channel) {
            ASSERT_NEAR(power[channel], expected[channel], 1e-4 * expected[channel] + 1e-9) << id;
        }
        ++clusters;
    }
    EXPECT_GT(clusters, 10U);
}

// One link to a triangle whose quarters, and one of their quarters, were opened.
struct OpenTriangle {
    OpenTriangle() : prepared(scene()), solution(prepared.scene, *prepared.colors, prepared.faces()) {
        open(kGeometryRoot);
        const NodeId cluster = solution.hierarchy[kGeometryRoot].first_child;
        open(cluster);
        whole = solution.hierarchy[cluster].first_child;
        open(whole);
        open(solution.hierarchy[whole].first_child + 3);
        solution.lighting.grow(prepared.control);
    }

    static SceneDescription scene() {
        SceneBuilder builder;
        const std::uint32_t grey = builder.material(Rgb(0.5F));
        builder.quad({0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, grey);
        builder.quad({5, 0, 0}, {7, 0, 0}, {7, 1, 0}, {5, 1, 0}, grey);
        builder.point_light({0, 0, 3}, Rgb(10));
        return builder.description;
    }
    void open(NodeId id) { solution.hierarchy.open(std::span(&id, 1), prepared.control); }
    [[nodiscard]] Rgb radiosity_of_lamp() const { return solution.hierarchy[lamp()].emission; }
    [[nodiscard]] NodeId lamp() const { return solution.hierarchy.infinite_and_lamps()[0]; }

    Prepared prepared;
    Solution solution;
    NodeId whole = 0;
};

Link lamp_link(const OpenTriangle& scene, NodeId receiver, Vec3 shape, float form_factor) {
    Link link;
    link.receiver = receiver;
    link.sender = scene.lamp();
    link.shape = shape;
    link.form_factor = form_factor;
    link.visibility = 0.5F;
    return link;
}

TEST(PushPull, irradiance_pushed_to_quarters_keeps_its_mean_and_its_course) {
    OpenTriangle scene;
    const auto& nodes = scene.solution.hierarchy.nodes();
    ASSERT_EQ(nodes[scene.whole].kind, NodeKind::kElement);
    Links links{{lamp_link(scene, scene.whole, {0.6F, 0.9F, 1.5F}, 0.25F)}, {}};
    scene.solution.lighting.set_links(links, scene.prepared.control);
    scene.solution.lighting.iterate(scene.prepared.control);
    const float mean = 0.125F * scene.radiosity_of_lamp().g;
    EXPECT_NEAR(scene.solution.lighting.irradiance(scene.whole).g / mean, 1, 1e-6);
    std::size_t leaves = 0;
    for (const NodeId id : surface_leaves(scene.solution)) {
        if (nodes[id].instance != nodes[scene.whole].instance || nodes[id].source != nodes[scene.whole].source ||
            nodes[id].back != nodes[scene.whole].back) {
            continue;
        }
        ++leaves;
        for (int k = 0; k < 3; ++k) {
            const Vec2 w = nodes[id].weights[k];
            const float expected = mean * (0.6F * (1 - w.x - w.y) + 0.9F * w.x + 1.5F * w.y);
            EXPECT_NEAR(scene.solution.lighting.corner_irradiance(id)[k].g / expected, 1, 1e-5);
        }
    }
    EXPECT_EQ(leaves, 7U);
}

TEST(PushPull, irradiance_of_levels_adds_up) {
    OpenTriangle scene;
    const NodeId quarter = scene.solution.hierarchy[scene.whole].first_child + 1;
    Links links{{lamp_link(scene, scene.whole, Vec3(1.0F), 0.25F), lamp_link(scene, quarter, Vec3(1.0F), 0.5F)}, {}};
    scene.solution.lighting.set_links(links, scene.prepared.control);
    scene.solution.lighting.iterate(scene.prepared.control);
    const Rgb lamp = scene.radiosity_of_lamp();
    EXPECT_NEAR(scene.solution.lighting.irradiance(quarter).r / (0.375F * lamp.r), 1, 1e-6);
    EXPECT_NEAR(scene.solution.lighting.irradiance(quarter + 1).r / (0.125F * lamp.r), 1, 1e-6);
    EXPECT_NEAR(scene.solution.lighting.irradiance(scene.whole).r / (0.1875F * lamp.r), 1, 1e-6);
}

}  // namespace
}  // namespace gg::test
