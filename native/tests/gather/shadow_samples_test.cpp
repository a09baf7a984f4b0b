// Numbers of points of senders by how wide and how deep their shadows are.
#include "gather/shadow_samples.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "gather/classify.h"
#include "support/gather_scenes.h"
#include "support/grid_picture.h"

namespace gg::test {
namespace {

Node lamp_node() {
    Node node;
    node.kind = NodeKind::kLamp;
    return node;
}

// Of a lamp [m], or of the sun [rad].
float width_of(const Lamp& lamp, Vec3 direction) {
    Scene scene;
    scene.lamps.push_back(lamp);
    return sender_width(scene, lamp_node(), normalize(direction));
}

TEST(ShadowSamples, senders_are_as_wide_as_they_are_seen) {
    Lamp lamp;
    EXPECT_EQ(width_of(lamp, {0, 0, 1}), 0);
    lamp.half_x = {0.4F, 0, 0};
    lamp.half_y = {0, 0.3F, 0};
    lamp.shape = LampShape::kRectangle;
    EXPECT_NEAR(width_of(lamp, {0, 0, 1}), 1, 1e-6F);  // from corner to corner
    EXPECT_NEAR(width_of(lamp, {1, 0, 0}), 0.6F, 1e-6F);
    lamp.shape = LampShape::kEllipse;
    EXPECT_NEAR(width_of(lamp, {0, 0, 1}), 0.8F, 1e-6F);
    lamp.shape = LampShape::kSphere;
    lamp.radius = 0.2F;
    EXPECT_NEAR(width_of(lamp, {0, 1, 0}), 0.4F, 1e-6F);
    lamp.shape = LampShape::kDistant;
    lamp.cos_half_angle = std::cos(0.1F);
    EXPECT_NEAR(width_of(lamp, {0, 1, 0}), 0.2F, 1e-5F);
    Node element;
    element.kind = NodeKind::kElement;
    element.corner = {Vec3(0, 0, 0), {3, 0, 0}, {0, 4, 0}};
    EXPECT_NEAR(sender_width({}, element, {0, 0, 1}), 5, 1e-6F);
    EXPECT_NEAR(sender_width({}, element, {0, 1, 0}), 3, 1e-6F);
    Node cluster;
    cluster.radius = 2;
    EXPECT_EQ(sender_width({}, cluster, {0, 1, 0}), 4);
}

// A half metre wide, 3 m off, with something a metre above the floor: a penumbra of a quarter of a metre.
Shadow penumbra() {
    return {0.5F, 3, 1, 1, 0.01F, 1};
}

TEST(ShadowSamples, penumbras_take_eight_steps_a_pixel) {
    Shadow shadow = penumbra();
    EXPECT_NEAR(steps_in_pixels(shadow), 8 * 25, 1e-3F);
    shadow.pixel = 0.04F;  // from four times as far
    EXPECT_NEAR(steps_in_pixels(shadow), 8 * 25 / 4.0F, 1e-3F);
    shadow.occluder = 0.1F;
    EXPECT_NEAR(steps_in_pixels(shadow), 8 * 0.017241379F / 0.04F, 1e-4F);
    shadow.cosine = 0.5F;  // it spreads where light grazes
    EXPECT_NEAR(steps_in_pixels(shadow), 8 * 0.017241379F / 0.02F, 1e-4F);
    shadow.cosine = -1;  // receivers that look to all sides
    EXPECT_NEAR(steps_in_pixels(shadow), 8 * 0.017241379F / 0.01F, 1e-3F);
}

TEST(ShadowSamples, of_the_sun_grow_with_the_distance_of_what_is_in_the_way) {
    Shadow shadow{0.00925F, kInfinity, 2, 1, 0.001F, 1};
    EXPECT_NEAR(steps_in_pixels(shadow), 8 * 18.5F, 1e-3F);
    shadow.occluder = 4;
    EXPECT_NEAR(steps_in_pixels(shadow), 8 * 37.0F, 1e-3F);
}

TEST(ShadowSamples, have_no_bound_where_the_penumbra_is_unknown_or_boundless) {
    Shadow shadow = penumbra();
    shadow.occluder = 0;
    EXPECT_EQ(steps_in_pixels(shadow), kInfinity);
    shadow.occluder = 3;
    EXPECT_EQ(steps_in_pixels(shadow), kInfinity);
}

TEST(ShadowSamples, are_as_many_as_steps_that_can_be_seen) {
    Shadow shadow = penumbra();
    EXPECT_NEAR(shadow_samples(shadow, 1 / 150.0F), 150, 1e-3F);
    shadow.step = 0.5F;  // a dim sender
    EXPECT_NEAR(shadow_samples(shadow, 1 / 150.0F), 75, 1e-3F);
    shadow.occluder = 0.1F;  // a narrow penumbra
    EXPECT_NEAR(shadow_samples(shadow, 1 / 150.0F), 8 * 1.7241379F, 1e-3F);
    shadow.occluder = 1e-4F;
    EXPECT_EQ(shadow_samples(shadow, 1 / 150.0F), 4);
    EXPECT_EQ(shadow_samples(penumbra(), 1e-6F), 200);
    shadow.occluder = 0;
    EXPECT_EQ(shadow_samples(shadow, 1e-6F), 1024);
}

// What sites ask for of all senders that some of their rays reach.
class SitesLookedAt : public testing::Test {
  protected:
    SitesLookedAt() : scene_(viewed_lamp_room()), picture_(scene_.description, scene_.camera, {}) {}

    // pixel: times the size of the picture's own.
    float samples_in_all(float threshold, float pixel) {
        ClassifySettings settings;
        settings.mean_radiosity = picture_.receivers.mean_radiosity();
        Classifier classifier(*picture_.solution, picture_.order, picture_.points, *picture_.prepared.tracer, settings);
        float sum = 0;
        for (std::size_t site = 0; site < picture_.receivers.site_count(); site += 5) {
            const std::vector<Receiver> seen = picture_.receivers.of(site);
            std::vector<Receiver> receivers(seen.begin(), seen.end());
            for (Receiver& receiver : receivers) {
                EXPECT_GT(receiver.pixel, 0);
                receiver.pixel *= pixel;
            }
            for (const SiteSender& sender : classifier.classify(receivers, threshold).senders) {
                EXPECT_GE(sender.samples, 1);
                EXPECT_LE(sender.samples, 1024);
                sum += sender.visibility > 0 && sender.visibility < 1 ? sender.samples : 0;
            }
        }
        return sum;
    }

    ViewedScene scene_;
    GridPicture picture_;
};

TEST_F(SitesLookedAt, take_fewer_samples_of_what_is_hardly_seen) {
    const float threshold = 0.01F * picture_.receivers.mean_radiosity();
    EXPECT_LT(samples_in_all(4 * threshold, 1), 0.5F * samples_in_all(threshold, 1));
}

TEST_F(SitesLookedAt, take_fewer_samples_from_afar) {
    const float threshold = 0.002F * picture_.receivers.mean_radiosity();
    const float close = samples_in_all(threshold, 1), far = samples_in_all(threshold, 100);
    EXPECT_LT(far, 0.8F * close);
    EXPECT_GT(far, 0);
}

}  // namespace
}  // namespace gg::test
