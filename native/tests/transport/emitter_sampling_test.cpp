#include "transport/emitter_sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "random_scenes.h"

namespace gg {
namespace {

const Vec3 kTarget{0.4F, -0.3F, 0.1F};

Lamp sphere(float radius) {
    Lamp lamp;
    lamp.shape = LampShape::kSphere;
    lamp.position = {1, 2, 3};
    lamp.radius = radius;
    lamp.radiance = {3, 2, 1};
    return lamp;
}

Lamp flat(LampShape shape) {
    Lamp lamp;
    lamp.shape = shape;
    lamp.position = {1, 1, 2};
    lamp.half_x = {0.6F, 0, 0.2F};
    lamp.half_y = {0.1F, 0.9F, 0};
    lamp.direction = normalize_or_zero(cross(lamp.half_y, lamp.half_x));
    lamp.radiance = {3, 2, 1};
    return lamp;
}

Lamp point() {
    Lamp lamp;
    lamp.position = {1, 2, 3};
    lamp.radiance = {3, 2, 1};
    return lamp;
}

Lamp distant(float half_angle) {
    Lamp lamp;
    lamp.shape = LampShape::kDistant;
    lamp.direction = normalize_or_zero({-1, -2, -3});
    lamp.irradiance = {3, 2, 1};
    lamp.cos_half_angle = std::cos(half_angle);
    return lamp;
}

// Mean of normal_irradiance times the cosine to n, on a grid of samples.
Rgb sampled_irradiance(const Lamp& lamp, Vec3 x, Vec3 n, int steps) {
    Vec3d sum(0);
    for (int i = 0; i < steps; ++i) {
        for (int j = 0; j < steps; ++j) {
            const LampSample sample = sample_lamp(lamp, x, (static_cast<float>(i) + 0.5F) / static_cast<float>(steps),
                                                  (static_cast<float>(j) + 0.5F) / static_cast<float>(steps));
            sum += Vec3d(sample.normal_irradiance) * static_cast<double>(std::max(0.0F, dot(n, sample.direction)));
        }
    }
    return Rgb(sum / static_cast<double>(steps * steps));
}

void expect_close(Rgb a, Rgb b, float relative) {
    EXPECT_LE(length(a - b), relative * length(b)) << a.r << " for " << b.r;
}

void expect_converges(const Lamp& lamp, Vec3 x, int steps, float relative) {
    const IrradianceVector truth = lamp_irradiance_vector(lamp, x);
    ASSERT_GT(truth.irradiance.r, 0);
    EXPECT_NEAR(length(truth.direction), 1, 1e-6F);
    expect_close(sampled_irradiance(lamp, x, truth.direction, steps), truth.irradiance, relative);
    const Vec3 tilted = normalize_or_zero(truth.direction + 0.3F * Frame(truth.direction).tangent);
    const Rgb expected = truth.irradiance * dot(tilted, truth.direction);
    expect_close(sampled_irradiance(lamp, x, tilted, steps), expected, relative);
}

TEST(emitter_sampling, every_shape_converges_to_its_irradiance_vector) {
    expect_converges(point(), kTarget, 1, 1e-6F);
    expect_converges(sphere(1), kTarget, 64, 1e-4F);
    expect_converges(sphere(0.001F), kTarget, 2, 1e-4F);
    expect_converges(flat(LampShape::kRectangle), kTarget, 64, 1e-4F);
    expect_converges(flat(LampShape::kEllipse), kTarget, 128, 1e-3F);
    expect_converges(distant(0.3F), kTarget, 64, 1e-4F);
    expect_converges(distant(0), kTarget, 1, 1e-6F);
}

TEST(emitter_sampling, sphere_irradiance_is_exact_from_few_samples) {
    const Lamp lamp = sphere(1);
    const IrradianceVector truth = lamp_irradiance_vector(lamp, kTarget);
    const float d2 = length_squared(lamp.position - kTarget);
    expect_close(truth.irradiance, lamp.radiance * (kPi / d2), 1e-6F);
    expect_close(sampled_irradiance(lamp, kTarget, truth.direction, 4), truth.irradiance, 3e-3F);
}

TEST(emitter_sampling, a_disk_that_faces_receivers_has_the_irradiance_of_one_at_any_distance) {
    Lamp lamp = sphere(0.5F);
    lamp.faces_receivers = true;
    for (const float distance : {0.0F, 0.01F, 0.3F, 0.5F, 2.0F}) {
        const Vec3 x = lamp.position - Vec3(0, 0, distance), n(0, 0, 1);
        // From the axis of a disk: pi L r^2 / (r^2 + d^2).
        const Rgb expected = lamp.radiance * (kPi * 0.25F / (0.25F + distance * distance));
        expect_close(lamp_irradiance(lamp, x, n), expected, 1e-5F);
        expect_close(sampled_irradiance(lamp, x, n, 32), expected, 3e-3F);
        const LampSample sample = sample_lamp(lamp, x, 0.3F, 0.8F);
        EXPECT_NEAR(sample.point.z, 3, 2e-5F);
        EXPECT_LE(length(sample.point - lamp.position), 0.5F + 1e-5F);
    }
}

TEST(emitter_sampling, a_receiver_within_a_sphere_has_the_light_of_its_surface) {
    const Lamp lamp = sphere(0.5F);
    expect_close(lamp_irradiance(lamp, lamp.position - Vec3(0, 0, 0.2F), {0, 0, 1}), lamp.radiance * kPi, 1e-5F);
}

TEST(emitter_sampling, far_lamps_of_all_shapes_obey_the_inverse_square_law) {
    const Vec3 x{1000, -2000, -3000};
    const Lamp rectangle = flat(LampShape::kRectangle);
    const Vec3 to_lamp = rectangle.position - x;
    const float d2 = length_squared(to_lamp);
    const float cosine = -dot(normalize_or_zero(to_lamp), rectangle.direction);
    const float area = 4 * length(cross(rectangle.half_x, rectangle.half_y));
    expect_close(lamp_irradiance_vector(rectangle, x).irradiance, rectangle.radiance * (area * cosine / d2), 1e-3F);
    expect_close(lamp_irradiance_vector(flat(LampShape::kEllipse), x).irradiance,
                 rectangle.radiance * (kPi / 4 * area * cosine / d2), 1e-3F);
    expect_close(lamp_irradiance_vector(point(), x).irradiance, Rgb(3, 2, 1) / length_squared(point().position - x),
                 1e-5F);
}

TEST(emitter_sampling, samples_lie_on_the_lamp_at_the_stated_distance) {
    test::Random random(11);
    for (const Lamp& lamp : {sphere(1), flat(LampShape::kRectangle), flat(LampShape::kEllipse), point()}) {
        for (int i = 0; i < 100; ++i) {
            const LampSample sample =
                sample_lamp(lamp, kTarget, static_cast<float>(random.uniform()), static_cast<float>(random.uniform()));
            EXPECT_NEAR(length(sample.direction), 1, 1e-5F);
            EXPECT_LT(length(kTarget + sample.distance * sample.direction - sample.point), 1e-5F);
            const Vec3 local = sample.point - lamp.position;
            if (lamp.shape == LampShape::kSphere) {
                EXPECT_NEAR(length(local), lamp.radius, 2e-3F);  // grazing rays: square root of rounding
                EXPECT_LT(dot(local, sample.direction), 1e-3F);
            } else {
                EXPECT_NEAR(dot(local, lamp.direction), 0, 1e-6F);
            }
            if (lamp.shape == LampShape::kEllipse) {
                const Mat3 to_local = glm::inverse(Mat3(lamp.half_x, lamp.half_y, lamp.direction));
                EXPECT_LE(length(to_local * local), 1 + 1e-5F);
            }
        }
    }
}

TEST(emitter_sampling, distant_samples_stay_in_their_disk) {
    const Lamp lamp = distant(0.3F);
    test::Random random(12);
    for (int i = 0; i < 100; ++i) {
        const LampSample sample =
            sample_lamp(lamp, kTarget, static_cast<float>(random.uniform()), static_cast<float>(random.uniform()));
        EXPECT_EQ(sample.distance, kInfinity);
        EXPECT_GE(dot(sample.direction, -lamp.direction), lamp.cos_half_angle - 1e-6F);
        EXPECT_TRUE(is_finite(sample.point));
    }
}

TEST(emitter_sampling, flat_lamps_shine_to_one_side) {
    for (const LampShape shape : {LampShape::kRectangle, LampShape::kEllipse}) {
        const Lamp lamp = flat(shape);
        const Vec3 behind = lamp.position - 0.5F * lamp.direction;
        EXPECT_EQ(lamp_irradiance_vector(lamp, behind).irradiance, Rgb(0));
        EXPECT_EQ(sample_lamp(lamp, behind, 0.3F, 0.6F).normal_irradiance, Rgb(0));
        EXPECT_GT(sample_lamp(lamp, lamp.position + 0.5F * lamp.direction, 0.3F, 0.6F).normal_irradiance.r, 0);
    }
}

// The horizon of a receiver beside or before a lamp cuts it.
TEST(emitter_sampling, light_from_above_the_horizon_alone_counts) {
    for (const Lamp& lamp : {sphere(0.8F), flat(LampShape::kRectangle), flat(LampShape::kEllipse), sphere(0.1F)}) {
        for (const float tilt : {-0.3F, 0.0F, 0.4F}) {
            const Vec3 forward = lamp.shape == LampShape::kSphere ? Vec3(0, 0, -1) : lamp.direction;
            const Vec3 x = lamp.position + forward * 1.1F;
            const Vec3 n = normalize_or_zero(cross(forward, Vec3(1, 0.3F, 0)) - tilt * forward);
            const Rgb truth = sampled_irradiance(lamp, x, n, 400);
            EXPECT_LE(length(lamp_irradiance(lamp, x, n) - truth), 4e-3F * length(truth) + 1e-4F) << tilt;
        }
    }
    expect_close(lamp_irradiance(point(), kTarget, {0, 0, 1}), sampled_irradiance(point(), kTarget, {0, 0, 1}, 1),
                 1e-5F);
    EXPECT_EQ(lamp_irradiance(point(), kTarget, {0, 0, -1}), Rgb(0));
}

// Receivers on, in and beside lamps: finite everywhere.
TEST(emitter_sampling, touching_receivers_get_finite_light) {
    for (const Lamp& lamp : {sphere(1), flat(LampShape::kRectangle), flat(LampShape::kEllipse), point()}) {
        for (const Vec3 x : {lamp.position, lamp.position + Vec3(0, 0, -1), lamp.position + Vec3(0.2F, 0.1F, 0),
                             lamp.position + lamp.half_x, lamp.position + lamp.half_x + lamp.half_y}) {
            const IrradianceVector vector = lamp_irradiance_vector(lamp, x);
            EXPECT_TRUE(is_finite(vector.irradiance) && is_finite(vector.direction));
            for (const Vec2 p : {Vec2(0, 0), Vec2(0.5F, 0.5F), Vec2(0, 0.5F), Vec2(0.999F, 0.2F)}) {
                const LampSample sample = sample_lamp(lamp, x, p.x, p.y);
                EXPECT_TRUE(is_finite(sample.point) && is_finite(sample.direction) && std::isfinite(sample.distance) &&
                            is_finite(sample.normal_irradiance));
            }
        }
    }
}

// A fixed (u, v) moves by little when the receiver moves by little: shadows have no seams.
TEST(emitter_sampling, sphere_samples_move_continuously_with_the_receiver) {
    const Lamp lamp = sphere(1);
    const float step = 1e-3F;
    for (int i = 0; i < 4000; ++i) {
        // Past the lamp on both sides of its height, where a flipping frame would jump.
        const Vec3 x{4, -2 + static_cast<float>(i) * step, 2.5F + 0.25F * static_cast<float>(i) * step};
        const Vec3 next = x + Vec3(0, step, 0.25F * step);
        EXPECT_LT(length(sample_lamp(lamp, x, 0.2F, 0.9F).point - sample_lamp(lamp, next, 0.2F, 0.9F).point), 5 * step);
    }
}

TEST(emitter_sampling, sphere_frame_is_orthonormal_close_to_its_singular_direction) {
    const Lamp lamp = sphere(1);
    for (const float offset : {0.0F, 1e-7F, 1e-5F, 1e-3F, 0.1F}) {
        const Vec3 x = lamp.position + Vec3(offset, -offset, 3);
        const IrradianceVector truth = lamp_irradiance_vector(lamp, x);
        expect_close(sampled_irradiance(lamp, x, truth.direction, 32), truth.irradiance, 1e-4F);
        EXPECT_NEAR(length(sample_lamp(lamp, x, 0.9F, 0.1F).direction), 1, 1e-5F);
    }
}

Lamp spot(Lamp lamp, float half_angle, float blend) {
    lamp.direction = normalize_or_zero(kTarget - lamp.position);
    lamp.is_spot = true;
    lamp.spot_cos = std::cos(half_angle);
    lamp.spot_smooth = (1 - lamp.spot_cos) * blend;
    return lamp;
}

TEST(spot, dims_samples_and_irradiance_alike) {
    for (const Lamp& lamp : {point(), sphere(0.05F)}) {
        const Lamp lit = spot(lamp, 0.4F, 0.5F);
        expect_converges(lit, kTarget, 16, 2e-3F);
        const Vec3 edge = kTarget + Vec3(1.2F, -0.6F, 0.1F);
        EXPECT_LT(lamp_irradiance_vector(lit, edge).irradiance.r,
                  0.9F * lamp_irradiance_vector(lamp, edge).irradiance.r);
        const Vec3 outside = kTarget + Vec3(20, 0, 0);
        EXPECT_EQ(lamp_irradiance_vector(lit, outside).irradiance, Rgb(0));
        EXPECT_EQ(sample_lamp(lit, outside, 0.4F, 0.4F).normal_irradiance, Rgb(0));
    }
}

}  // namespace
}  // namespace gg
