#include "scene/light_units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/messages.h"

namespace gg {
namespace {

// What Cycles 3.4.1 showed is in light_units.h; the numbers here are irradiances of a plane that it rendered.
LightDescription make_light(LightType type) {
    LightDescription light;
    light.name = "lamp";
    light.type = type;
    light.power = Rgb(100, 50, 0);
    light.to_world.translation = {1, 2, 3};
    light.stable_id = 77;
    return light;
}

Lamp convert(const LightDescription& light) {
    Messages messages;
    const std::optional<Lamp> lamp = make_lamp(light, messages);
    EXPECT_TRUE(messages.all().empty());
    return lamp.value_or(Lamp{});
}

TEST(LightUnits, a_point_of_100_watts_gives_1_9894_at_2_metres) {
    const Lamp lamp = convert(make_light(LightType::kPoint));
    EXPECT_EQ(lamp.shape, LampShape::kPoint);
    EXPECT_EQ(lamp.position, Vec3(1, 2, 3));
    EXPECT_EQ(lamp.stable_id, 77U);
    EXPECT_EQ(lamp.name, "lamp");
    EXPECT_NEAR(lamp.radiance.r / (2 * 2), 1.98944, 1e-4);
    EXPECT_NEAR(lamp.radiance.g / (2 * 2), 0.99472, 1e-4);
    EXPECT_EQ(lamp.radiance.b, 0);
}

TEST(LightUnits, a_sphere_has_the_points_intensity_whatever_its_radius_and_scale) {
    LightDescription light = make_light(LightType::kPoint);
    light.to_world.linear *= 0.5F;
    for (const float radius : {0.001F, 0.1F, 1.0F}) {
        light.radius = radius;
        const Lamp lamp = convert(light);
        EXPECT_EQ(lamp.shape, LampShape::kSphere);
        EXPECT_EQ(lamp.radius, radius);
        EXPECT_NEAR(lamp.radiance.r * kPi * radius * radius, 100 / (4 * kPi), 1e-4);
    }
    light.radius = 1e-6F;
    EXPECT_EQ(convert(light).shape, LampShape::kPoint);
}

TEST(LightUnits, area_radiance_is_power_over_four_placed_areas) {
    LightDescription light = make_light(LightType::kArea);
    light.size_x = 2;
    light.size_y = 0.5F;
    for (const float scale : {1.0F, 2.0F}) {
        light.to_world.linear = Mat3(scale);
        light.shape = AreaShape::kRectangle;
        const Lamp rectangle = convert(light);
        EXPECT_EQ(rectangle.shape, LampShape::kRectangle);
        EXPECT_EQ(rectangle.half_x, Vec3(scale, 0, 0));
        EXPECT_EQ(rectangle.half_y, Vec3(0, 0.25F * scale, 0));
        EXPECT_NEAR(rectangle.radiance.r, 25 / (scale * scale), 1e-4);
        light.shape = AreaShape::kEllipse;
        const Lamp ellipse = convert(light);
        EXPECT_EQ(ellipse.shape, LampShape::kEllipse);
        EXPECT_NEAR(ellipse.radiance.r, 25 / (kPi / 4 * scale * scale), 1e-4);
    }
}

TEST(LightUnits, a_disk_of_1_metre_gives_50_at_half_a_metre_as_measured) {
    LightDescription light = make_light(LightType::kArea);
    light.size_x = light.size_y = 1;
    light.shape = AreaShape::kEllipse;
    // Irradiance on the axis of a uniform disk: pi L r^2 / (r^2 + h^2).
    EXPECT_NEAR(kPi * convert(light).radiance.r * 0.25 / (0.25 + 0.25), 50.0, 1e-3);
}

TEST(LightUnits, area_lights_shine_along_minus_z_also_when_mirrored_or_sheared) {
    LightDescription light = make_light(LightType::kArea);
    light.size_x = light.size_y = 1;
    light.to_world.linear = Mat3({-1, 0, 0}, {0, 1, 0}, {0, 0, 1});
    EXPECT_EQ(convert(light).direction, Vec3(0, 0, -1));
    light.to_world.linear = Mat3({1, 0, 0}, {0, 1, 0}, {0, 0, -1});
    EXPECT_EQ(convert(light).direction, Vec3(0, 0, 1));
    light.to_world.linear = Mat3({1, 0, 0}, {0.5F, 1, 0}, {0.3F, 0.2F, 1});  // across the panel, not along its Z
    const Lamp sheared = convert(light);
    EXPECT_EQ(sheared.direction, Vec3(0, 0, -1));
    EXPECT_NEAR(sheared.radiance.r, 25, 1e-4);
}

TEST(LightUnits, spot_falls_off_like_cycles) {
    LightDescription light = make_light(LightType::kSpot);
    light.spot_angle = kPi / 3;
    // Irradiance over that on the axis is spot_factor * cos^3.
    const struct {
        float blend;
        double degrees;
        double measured;
    } cases[] = {{0, 15, 1.731829}, {0, 29.9, 1.123570}, {0, 30.5, 0}, {1, 20, 0.891244}, {0.5F, 25, 0.872379}};
    for (const auto& [blend, degrees, measured] : cases) {
        light.spot_blend = blend;
        const Lamp lamp = convert(light);
        EXPECT_TRUE(lamp.is_spot);
        const double cosine = std::cos(degrees * kPi / 180);
        EXPECT_NEAR(1.989439 * spot_factor(lamp, static_cast<float>(cosine)) * cosine * cosine * cosine, measured, 2e-4)
            << degrees;
    }
    EXPECT_EQ(convert(light).direction, Vec3(0, 0, -1));
}

TEST(LightUnits, spot_factor_is_one_on_the_axis_zero_behind_and_one_for_other_lamps) {
    LightDescription light = make_light(LightType::kSpot);
    light.spot_angle = kPi;
    light.spot_blend = 0.5F;
    EXPECT_FLOAT_EQ(spot_factor(convert(light), 1.0F), 1);
    EXPECT_EQ(spot_factor(convert(light), 0.0F), 0);
    EXPECT_EQ(spot_factor(convert(light), -0.5F), 0);
    light.spot_angle = 0;
    EXPECT_EQ(spot_factor(convert(light), 0.9F), 0);
    EXPECT_EQ(spot_factor(convert(make_light(LightType::kPoint)), -0.5F), 1);
}

TEST(LightUnits, sun_strength_is_irradiance) {
    LightDescription light = make_light(LightType::kSun);
    light.power = Rgb(3);
    light.angle = 10 * kPi / 180;
    light.to_world.linear *= 2.0F;
    const Lamp lamp = convert(light);
    EXPECT_EQ(lamp.shape, LampShape::kDistant);
    EXPECT_EQ(lamp.irradiance, Rgb(3));
    EXPECT_EQ(lamp.direction, Vec3(0, 0, -1));
    EXPECT_NEAR(lamp.cos_half_angle, std::cos(5 * kPi / 180), 1e-6);
}

TEST(LightUnits, a_lamp_without_power_is_left_out_silently) {
    LightDescription light = make_light(LightType::kPoint);
    light.power = Rgb(0);
    Messages messages;
    EXPECT_FALSE(make_lamp(light, messages));
    EXPECT_TRUE(messages.all().empty());
}

void expect_left_out(const LightDescription& light) {
    Messages messages;
    EXPECT_FALSE(make_lamp(light, messages));
    ASSERT_EQ(messages.all().size(), 1U);
    EXPECT_EQ(messages.all()[0].object, "lamp");
}

TEST(LightUnits, broken_lamps_are_left_out_with_a_message) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    LightDescription light = make_light(LightType::kPoint);
    light.power.g = -1;
    expect_left_out(light);
    light.power.g = nan;
    expect_left_out(light);

    light = make_light(LightType::kPoint);
    light.radius = -1;
    expect_left_out(light);
    light.radius = 0;
    light.to_world.translation.z = kInfinity;
    expect_left_out(light);

    light = make_light(LightType::kSun);
    light.to_world.linear = Mat3(0.0F);
    expect_left_out(light);

    light = make_light(LightType::kArea);  // sizes are 0
    expect_left_out(light);
    light.size_x = light.size_y = 1;
    light.to_world.linear[0] = Vec3(0);
    expect_left_out(light);
}

}  // namespace
}  // namespace gg
