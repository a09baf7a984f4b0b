#include "transport/spherical_rectangle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "transport/emitter_sampling.h"

namespace gg::test {
namespace {

TEST(SphericalRectangle, a_face_of_a_cube_is_a_sixth_of_the_sphere) {
    const SphericalRectangle face({1, 2, 4}, {1, 0, 0}, {0, 1, 0}, {1, 2, 3});
    EXPECT_NEAR(face.solid_angle(), 4 * kPi / 6, 1e-5F);
}

// Equal parts of the square are equal solid angles: the corner quarter of a face, seen from the middle, is a quarter.
TEST(SphericalRectangle, halves_of_the_square_are_halves_of_the_angle) {
    const SphericalRectangle face({0, 0, 1}, {2, 0, 0}, {0, 1, 0}, {0, 0, 0});
    EXPECT_NEAR(face.point(0.5F, 0.5F).x, 0, 1e-5F);
    EXPECT_NEAR(face.point(0.5F, 0.5F).y, 0, 1e-5F);
    EXPECT_NEAR(face.point(0.0F, 0.5F).x, -2, 1e-4F);
    EXPECT_NEAR(face.point(1.0F, 0.5F).x, 2, 1e-4F);
    EXPECT_NEAR(face.point(0.3F, 1.0F).y, 1, 1e-4F);
    const float part = face.point(0.25F, 0.5F).x;  // a quarter of the angle lies left of it
    const SphericalRectangle left({0.5F * (part - 2), 0, 1}, {0.5F * (part + 2), 0, 0}, {0, 1, 0}, {0, 0, 0});
    EXPECT_NEAR(left.solid_angle() / face.solid_angle(), 0.25F, 1e-4F);
}

// On a wall that touches the lamp's plane, h away from it: by area, one of 16 samples would now and then outweigh all.
TEST(SphericalRectangle, light_next_to_a_lamp_is_even_over_its_samples) {
    Lamp lamp;
    lamp.shape = LampShape::kRectangle;
    lamp.half_x = {1, 0, 0};
    lamp.half_y = {0, 1, 0};
    lamp.direction = {0, 0, -1};
    lamp.radiance = Rgb(1);
    const Vec3 normal(-1, 0, 0);
    for (const float h : {0.5F, 0.1F, 0.01F}) {
        const Vec3 x(1.0F, 0.1F, -h);
        const float exact = lamp_irradiance(lamp, x, normal).x;
        float mean = 0, most = 0;
        constexpr int kSide = 64;
        for (int k = 0; k < kSide * kSide; ++k) {
            const LampSample sample = sample_lamp(lamp, x, (static_cast<float>(k % kSide) + 0.5F) / kSide,
                                                  (static_cast<float>(k / kSide) + 0.5F) / kSide);
            const float light = sample.normal_irradiance.x * std::max(0.0F, dot(normal, sample.direction));
            mean += light / (kSide * kSide);
            most = std::max(most, light);
            EXPECT_NEAR(sample.point.z, 0, 1e-5F);
        }
        EXPECT_NEAR(mean / exact, 1, 1e-3F) << h;
        EXPECT_LT(most, 4 * exact) << h;
    }
}

}  // namespace
}  // namespace gg::test
