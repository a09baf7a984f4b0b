// Points on senders, and what they bring.
#include "gather/sender_points.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/distance.h"
#include "gather/sender_light.h"
#include "support/law_scenes.h"
#include "transport/form_factor.h"

namespace gg::test {
namespace {

TEST(ClusterPoints, power_is_that_of_the_faces) {
    Prepared prepared(mixed_scene());
    const auto solution = prepared.solve(0.05F);
    const Hierarchy& hierarchy = hierarchy_of(*solution);
    const ClusterPoints points(*solution, prepared.control);
    int clusters = 0;
    for (NodeId id = 0; id < hierarchy.nodes().size(); ++id) {
        const Node& node = hierarchy[id];
        if (!is_cluster(node) || node.child_count > 0) {
            continue;
        }
        double expected = 0, found = 0;
        hierarchy.for_each_triangle(node, [&](std::uint32_t instance, std::uint32_t triangle) {
            for (const bool back : {false, true}) {
                if (has_side(hierarchy.scene().sides_of(instance, triangle), back)) {
                    expected +=
                        static_cast<double>(luminance(face_radiosity(*solution, instance, triangle, back)) / kPi *
                                            length(world_area_vector(hierarchy.scene(), instance, triangle)));
                }
            }
        });
        for (std::uint32_t i = 0; i < kClusterPoints && !points.of(id).empty(); ++i) {
            const FacePoint point = points.of(id)[i];
            found += static_cast<double>(luminance(point.power));
            EXPECT_NEAR(length(point.normal), 1, 1e-4F);
            EXPECT_LT(length(point.position - node.center), 1.001F * node.radius);
        }
        EXPECT_NEAR(found, expected, 1e-3 * expected);
        ++clusters;
    }
    EXPECT_GT(clusters, 3);
}

// Of a floor element from above: the mean over many points is the closed form.
TEST(SenderLight, points_of_an_element_agree_with_its_polygon) {
    Prepared prepared(furnace(0.5F, false));
    const auto solution = prepared.solve();
    const Hierarchy& hierarchy = hierarchy_of(*solution);
    for (NodeId id = 0; id < hierarchy.nodes().size(); ++id) {
        const Node& node = hierarchy[id];
        if (node.kind != NodeKind::kElement || node.depth > 0) {
            continue;
        }
        const Vec3 x = node.center + 3.0F * node.normal, n = -node.normal;
        float sum = 0;
        constexpr int kCount = 4096;
        for (std::uint32_t i = 0; i < kCount; ++i) {
            sum += SenderSampler(*solution, id, x, n).point(i).weight / kCount;
        }
        const float exact = luminance(unoccluded_irradiance(*solution, id, x, n));
        const float sampled = sum * node.area / kPi;
        EXPECT_NEAR(sampled / exact, 1, 0.01F);
        const IrradianceVector vector = irradiance_vector(*solution, id, x);
        EXPECT_NEAR(luminance(vector.irradiance) * dot(vector.direction, n) / exact, 1, 1e-3F);
        EXPECT_EQ(luminance(unoccluded_irradiance(*solution, id, node.center - 1.0F * node.normal, node.normal)), 0);
    }
}

// Of an element that is bright in parts only, points bring what its parts do: hiding the dark ones hides little.
TEST(SenderLight, points_of_an_uneven_element_are_as_bright_as_its_parts) {
    Prepared prepared(lamp_room(0.5F));
    const auto solution = prepared.solve();
    const Hierarchy& hierarchy = hierarchy_of(*solution);
    int uneven = 0;
    for (NodeId id = 0; id < hierarchy.nodes().size(); ++id) {
        const Node& node = hierarchy[id];
        if (node.kind != NodeKind::kElement || node.depth > 0 || node.child_count == 0) {
            continue;
        }
        const Vec3 x = node.center + 2.0F * node.radius * node.normal, n = -node.normal;
        for (NodeId child = node.first_child; child < node.first_child + node.child_count; ++child) {
            const SenderSampler whole(*solution, id, x, n);
            const auto& c = hierarchy[child].corner;
            float sum = 0;
            constexpr int kCount = 16384;
            for (std::uint32_t i = 0; i < kCount; ++i) {
                if (distance_to_triangle(whole.place(i).target, c) < 1e-4F * node.radius) {
                    sum += whole.point(i).weight / kCount;
                }
            }
            float expected = 0;  // of the smallest parts
            for (NodeId part = child; part < hierarchy.nodes().size(); ++part) {
                if (hierarchy[part].kind == NodeKind::kElement && hierarchy[part].child_count == 0 &&
                    hierarchy[part].instance == node.instance && hierarchy[part].back == node.back &&
                    distance_to_triangle(hierarchy[part].center, c) < 1e-4F * node.radius) {
                    expected += point_to_triangle(x, n, hierarchy[part].corner[0], hierarchy[part].corner[1],
                                                  hierarchy[part].corner[2]) *
                                luminance(radiosity_of(*solution, part));
                }
            }
            if (!(expected > 0)) {
                continue;  // the outside of the room
            }
            EXPECT_NEAR(sum * node.area / kPi / expected, 1, 0.03F);
            uneven +=
                std::abs(luminance(radiosity_of(*solution, child)) / luminance(radiosity_of(*solution, id)) - 1) > 0.2F;
        }
    }
    EXPECT_GT(uneven, 4);
}

TEST(SenderLight, a_far_point_of_a_cluster_has_the_inverse_square) {
    const FacePoint point{{0, 0, 2}, {0, 0, -1}, Rgb(3.0F)};
    EXPECT_NEAR(irradiance_from(point, 1, point.position, {0, 0, 1}, 1e-6F).x, 3.0F / 4, 1e-5F);
    EXPECT_NEAR(irradiance_from(point, 2, point.position, {0, 0, 1}, 1e-6F).x, 6.0F / 4, 1e-5F);
    EXPECT_EQ(irradiance_from(point, 1, -point.position, {0, 0, -1}, 1e-6F).x, 0);    // its back
    EXPECT_LE(irradiance_from(point, 1, {0, 0, 1e-4F}, {0, 0, 1}, 1.0F).x, 3 * kPi);  // at most that of its disk
}

TEST(SenderLight, corners_have_the_elements_mean_and_differ_where_light_does) {
    Prepared prepared(lamp_room(0.5F));
    const auto solution = prepared.solve();
    const Hierarchy& hierarchy = hierarchy_of(*solution);
    int uneven = 0;
    for (NodeId id = 0; id < hierarchy.nodes().size(); ++id) {
        if (hierarchy[id].kind == NodeKind::kElement && hierarchy[id].child_count == 0) {
            const auto corners = corner_radiosity(*solution, id);
            const float mean = luminance(corners[0] + corners[1] + corners[2]) / 3;
            EXPECT_NEAR(mean, luminance(radiosity_of(*solution, id)), 1e-4F * mean);
            uneven += std::abs(luminance(corners[0]) - mean) > 0.1F * mean;
        }
    }
    EXPECT_GT(uneven, 10);
}

// From afar an element is even, close by it is brighter where its bright corner is; in between nothing jumps.
TEST(SenderLight, elements_become_linear_without_a_jump) {
    Prepared prepared(lamp_room(0.5F));
    const auto solution = prepared.solve();
    const Hierarchy& hierarchy = hierarchy_of(*solution);
    NodeId chosen = kNone;
    float most = 0;
    for (NodeId id = 0; id < hierarchy.nodes().size(); ++id) {
        if (hierarchy[id].kind == NodeKind::kElement && hierarchy[id].child_count == 0) {
            const auto corners = corner_radiosity(*solution, id);
            const float difference = luminance(corners[0]) - std::max(luminance(corners[1]), luminance(corners[2]));
            if (difference > most) {
                most = difference;
                chosen = id;
            }
        }
    }
    ASSERT_NE(chosen, kNone);
    const Node& node = hierarchy[chosen];
    const auto at = [&](float share, float height) {
        const Vec3 x = glm::mix(node.corner[1], node.corner[0], share) + height * node.radius * node.normal;
        return luminance(unoccluded_irradiance(*solution, chosen, x, -node.normal));
    };
    EXPECT_GT(at(0.9F, 0.3F), 1.02F * at(0.1F, 0.3F));
    float before = at(0.9F, 7);
    for (float height = 7; height > 2; height -= 0.002F) {
        const float now = at(0.9F, height);
        EXPECT_NEAR(now, before, 0.003F * now) << height;
        before = now;
    }
}

}  // namespace
}  // namespace gg::test
