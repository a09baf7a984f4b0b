#include "transport/bilinear_warp.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "transport/emitter_sampling.h"

namespace gg {
namespace {

TEST(BilinearWarp, the_corners_and_the_middle_of_an_even_function_stay) {
    const BilinearWarp even({2, 2, 2, 2});
    for (const Vec2 place : {Vec2(0, 0), Vec2(1, 0), Vec2(0.5F, 0.5F), Vec2(0.25F, 1)}) {
        EXPECT_NEAR(length(even.place(place.x, place.y) - place), 0, 1e-6F);
        EXPECT_NEAR(even.density(place), 1, 1e-6F);
    }
}

// A ramp from 0 to 1: the median lies at the root of a half.
TEST(BilinearWarp, a_ramp_has_its_median) {
    const BilinearWarp ramp({1e-6F, 1, 1e-6F, 1});
    EXPECT_NEAR(ramp.place(0.5F, 0.3F).x, std::sqrt(0.5F), 1e-4F);
    EXPECT_NEAR(ramp.place(0.5F, 0.3F).y, 0.3F, 1e-6F);
    EXPECT_NEAR(ramp.density({0.5F, 0.5F}), 1, 1e-4F);
}

// The mean of f / density over the warped points is the integral of f.
TEST(BilinearWarp, density_belongs_to_the_places) {
    const BilinearWarp warp({0.2F, 1, 3, 0.5F});
    const Sequence4 sequence(5);
    double area = 0, moment = 0;
    constexpr int kCount = 20000;
    for (std::uint32_t i = 0; i < kCount; ++i) {
        const Vec2 place = warp.place(sequence(i, 0), sequence(i, 1));
        area += 1.0 / kCount / static_cast<double>(warp.density(place));
        moment += static_cast<double>(place.x * place.y / warp.density(place)) / kCount;
    }
    EXPECT_NEAR(area, 1, 2e-3);
    EXPECT_NEAR(moment, 0.25, 2e-3);
}

// A window beside a wall: the same mean, and samples that weigh nearly the same.
TEST(LampSampler, samples_follow_the_cosine) {
    Lamp lamp;
    lamp.shape = LampShape::kRectangle;
    lamp.radiance = Rgb(1);
    lamp.position = {0, 1, 0};
    lamp.half_x = {0, 1, 0};
    lamp.half_y = {0, 0, 1};
    lamp.direction = {1, 0, 0};
    const Vec3 x{0.6F, 0, 0.2F}, n{0, 1, 0};
    const LampSampler plain(lamp, x), warped(lamp, x, n);
    const Sequence4 sequence(3);
    struct Moments {
        float sum = 0, squares = 0;
        void add(const LampSample& sample, Vec3 normal) {
            const float light = sample.normal_irradiance.x * std::max(0.0F, dot(normal, sample.direction));
            sum += light;
            squares += light * light;
        }
        [[nodiscard]] float variance(float count) const { return squares * count / (sum * sum) - 1; }
    } of_plain, of_warped;
    constexpr int kCount = 4096;
    for (std::uint32_t i = 0; i < kCount; ++i) {
        of_plain.add(plain.sample(sequence(i, 0), sequence(i, 1)), n);
        of_warped.add(warped.sample(sequence(i, 0), sequence(i, 1)), n);
    }
    const float exact = lamp_irradiance(lamp, x, n).x;
    EXPECT_NEAR(of_plain.sum / kCount / exact, 1, 5e-3F);
    EXPECT_NEAR(of_warped.sum / kCount / exact, 1, 5e-3F);
    EXPECT_LT(of_warped.variance(kCount), 0.25F * of_plain.variance(kCount));
}

}  // namespace
}  // namespace gg
