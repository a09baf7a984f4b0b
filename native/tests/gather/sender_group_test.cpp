// What is worked out for many receivers at a time, held against one receiver after the other.
#include "gather/sender_group.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "gather/sender_light.h"
#include "gather/sender_measure.h"
#include "gather/sender_place.h"
#include "support/law_scenes.h"

namespace gg::test {
namespace {

// The mixed scene with lamps of every shape.
SceneDescription all_lamps() {
    SceneDescription scene = mixed_scene();
    const auto of_type = [&](LightType type) {
        return *std::find_if(scene.lights.begin(), scene.lights.end(),
                             [&](const LightDescription& light) { return light.type == type; });
    };
    LightDescription bulb = of_type(LightType::kPoint);
    bulb.radius = 0.1F;
    bulb.to_world.translation = {0.7F, 0.8F, 2.2F};
    scene.lights.push_back(bulb);
    bulb.soft_falloff = true;
    bulb.to_world.translation = {2.7F, 0.8F, 2.0F};
    scene.lights.push_back(bulb);
    bulb.type = LightType::kSpot;
    bulb.spot_angle = 1.2F;
    bulb.spot_blend = 0.5F;
    scene.lights.push_back(bulb);
    LightDescription disk = of_type(LightType::kArea);
    disk.shape = AreaShape::kEllipse;
    disk.size_y = 0.3F;
    disk.to_world.translation = {1, 1, 2.3F};
    scene.lights.push_back(disk);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        scene.lights[i].stable_id = i + 1;
    }
    return scene;
}

struct Senders {
    Prepared prepared{all_lamps()};
    std::shared_ptr<const Solution> solution = prepared.solve(0.05F);
    const Hierarchy& hierarchy = hierarchy_of(*solution);
    ClusterPoints clusters{*solution, prepared.control};

    // Clusters, elements and lamps; a part of them, but all lamps.
    [[nodiscard]] std::vector<NodeId> some() const {
        std::vector<NodeId> found;
        for (NodeId id = 0; id < hierarchy.nodes().size(); ++id) {
            const Node& node = hierarchy[id];
            const bool lit = !is_cluster(node) || !clusters.of(id).empty();
            const bool surface = is_cluster(node) || node.kind == NodeKind::kElement;
            if ((surface && lit && id % 7 == 0) || node.kind == NodeKind::kLamp) {
                found.push_back(id);
            }
        }
        return found;
    }
};

// A place and a unit normal.
struct Point {
    Vec3 x{0.0F}, n{0.0F};
};

// In the room and, one in three, close to the sender; half of them look to it.
std::vector<Point> points_around(const Node& sender, std::size_t count) {
    const Sequence6 sequence(sender.stable_id);
    std::vector<Point> points;
    for (std::uint32_t i = 0; i < count; ++i) {
        Point point{kRoomSize * Vec3(sequence(i, 0), sequence(i, 1), sequence(i, 2)), Vec3(0.0F)};
        if (i % 3 == 0) {
            point.x = sender.center + sender.radius * (point.x - 0.5F * kRoomSize);
        }
        const Vec3 any = normalize_or_zero(Vec3(sequence(i, 3), sequence(i, 4), sequence(i, 5)) - Vec3(0.5F));
        point.n = i % 2 == 0 ? any : normalize_or_zero(sender.center - point.x + 0.2F * any);
        points.push_back(point);
    }
    return points;
}

SenderPoint one_point(const Senders& senders, NodeId id, const Point& at, std::uint32_t index) {
    const Node& node = senders.hierarchy[id];
    if (!is_cluster(node)) {
        return SenderSampler(*senders.solution, id, at.x, at.n).point(index);
    }
    const FacePoint point = senders.clusters.of(id)[index];
    const Vec3 to = point.position - at.x;
    return {to, false, luminance(irradiance_from(point, 1, to, at.n, cluster_disk(node)))};
}

TEST(SenderGroup, sees_the_points_that_one_receiver_sees) {
    const Senders senders;
    SenderGroup group(*senders.solution, senders.clusters);
    GroupPoint seen;
    int lit = 0;
    for (const NodeId id : senders.some()) {
        const auto points = points_around(senders.hierarchy[id], 13);
        group.begin(id);
        for (const Point& at : points) {
            group.add(at.x, at.n);
        }
        for (std::uint32_t index = 0; index < 5; ++index) {
            group.see(index, seen);
            for (std::size_t k = 0; k < points.size(); ++k) {
                const SenderPoint expected = one_point(senders, id, points[k], index);
                EXPECT_EQ(group.infinite(), expected.infinite);
                EXPECT_NEAR(seen.weight[k], expected.weight, 2e-3F * expected.weight + 1e-6F) << id << " " << k;
                if (expected.weight > 0) {
                    ++lit;
                    EXPECT_LE(length(seen.direction(k) - expected.direction), 1e-3F * length(expected.direction)) << id;
                }
            }
        }
    }
    EXPECT_GT(lit, 10000);
}

TEST(SenderGroup, has_the_light_that_one_receiver_has) {
    const Senders senders;
    SenderGroup group(*senders.solution, senders.clusters);
    std::vector<Rgb> light;
    int lit = 0;
    for (const NodeId id : senders.some()) {
        const auto points = points_around(senders.hierarchy[id], 13);
        group.begin(id);
        for (const Point& at : points) {
            group.add(at.x, at.n);
        }
        group.light(light);
        ASSERT_EQ(light.size(), points.size());
        for (std::size_t k = 0; k < points.size(); ++k) {
            const Rgb expected =
                unoccluded_irradiance(*senders.solution, senders.clusters, id, points[k].x, points[k].n);
            // Form factors near zero are sums of larger terms.
            const float rounding = senders.hierarchy[id].kind == NodeKind::kElement
                                       ? 1e-6F * luminance(radiosity_of(*senders.solution, id))
                                       : 1e-5F;
            EXPECT_NEAR(luminance(light[k]), luminance(expected), 5e-4F * luminance(expected) + rounding) << id;
            lit += luminance(expected) > 0 ? 1 : 0;
        }
    }
    EXPECT_GT(lit, 2000);
}

TEST(SenderGroup, what_has_one_point_has_one) {
    const Senders senders;
    SenderGroup group(*senders.solution, senders.clusters);
    int single = 0;
    for (const NodeId id : senders.some()) {
        group.begin(id);
        const Node& node = senders.hierarchy[id];
        const bool point =
            node.kind == NodeKind::kLamp && senders.hierarchy.scene().lamps[node.source].shape == LampShape::kPoint;
        if (point || is_cluster(node)) {
            EXPECT_EQ(group.most_points(), point ? 1U : kClusterPoints);
        } else {
            EXPECT_GT(group.most_points(), 500U);
        }
        single += point ? 1 : 0;
    }
    EXPECT_EQ(single, 1);
}

TEST(SenderMeter, measures_what_its_receivers_say_one_by_one) {
    const Senders senders;
    SenderMeter meter(*senders.solution, senders.clusters);
    int measured = 0, crossing = 0;
    for (const NodeId id : senders.some()) {
        const Node& node = senders.hierarchy[id];
        std::vector<Receiver> receivers;
        for (const Point& at : points_around(node, 21)) {
            receivers.push_back({at.x, at.n, at.n, kNone, 0.5F, 1});
        }
        if (id % 2 == 0) {  // all of them far
            std::erase_if(receivers, [&](const Receiver& receiver) {
                return length(receiver.position - node.center) < kPointDistance * node.radius;
            });
        }
        std::vector<Vec3> vectors;
        float largest = 0;
        bool horizon = false;
        for (const Receiver& receiver : receivers) {
            const IrradianceVector v = irradiance_vector(*senders.solution, senders.clusters, id, receiver.position);
            const float size = luminance(v.irradiance);
            if (!is_below_horizon(senders.hierarchy.scene(), node, receiver.position, receiver.shading_normal) &&
                size > 0) {
                vectors.push_back(size * v.direction);
                largest = std::max(largest, size);
                horizon = horizon ||
                          crosses_horizon(senders.hierarchy.scene(), node, receiver.position, receiver.shading_normal);
            }
        }
        Vec3 mean(0.0F);
        for (const Vec3& v : vectors) {
            mean += v / static_cast<float>(vectors.size());
        }
        float spread = 0;
        for (const Vec3& v : vectors) {
            spread = std::max(spread, 2 * length(v - mean));
        }
        meter.look_from(receivers);
        const SenderMeasure found = meter.measure(id, receivers.size());
        EXPECT_NEAR(luminance(found.irradiance), length(mean), 1e-3F * length(mean) + 1e-7F) << id;
        EXPECT_NEAR(found.largest, largest, 1e-3F * largest) << id;
        EXPECT_NEAR(found.spread, spread, 1e-3F * (spread + largest)) << id;
        EXPECT_EQ(found.horizon, horizon) << id;
        if (length(mean) > 1e-3F * largest) {
            EXPECT_LT(length(found.direction - normalize_or_zero(mean)), 2e-3F) << id;
        }
        measured += vectors.empty() ? 0 : 1;
        crossing += horizon ? 1 : 0;
    }
    EXPECT_GT(measured, 300);
    EXPECT_GT(crossing, 30);
}

TEST(SenderMeter, nothing_is_measured_where_nobody_looks) {
    const Senders senders;
    SenderMeter meter(*senders.solution, senders.clusters);
    meter.look_from({});
    for (const NodeId id : senders.some()) {
        EXPECT_EQ(meter.measure(id, 16).largest, 0);
    }
}

}  // namespace
}  // namespace gg::test
