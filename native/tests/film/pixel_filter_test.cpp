#include "film/pixel_filter.h"

#include <gtest/gtest.h>

#include <vector>

namespace gg {
namespace {

double integral(const PixelFilter& filter, int power) {
    double sum = 0;
    constexpr int kSteps = 20000;
    for (int step = 0; step < kSteps; ++step) {
        const double x = 6.0 * (step + 0.5) / kSteps - 3;
        sum += static_cast<double>(filter.weight(static_cast<float>(x))) * std::pow(x, power);
    }
    return sum * 6.0 / kSteps;
}

TEST(pixel_filter, blackman_harris_integrates_to_its_constant_term) {
    EXPECT_NEAR(integral(PixelFilter(FilterType::kBlackmanHarris, 1.5F), 0), 3 * 0.35875, 1e-4);
    EXPECT_NEAR(PixelFilter(FilterType::kBlackmanHarris, 1.5F).weight(0), 1, 1e-6);
    EXPECT_NEAR(PixelFilter(FilterType::kBlackmanHarris, 1.5F).weight(1.5F), 0.00006, 1e-5);
}

TEST(pixel_filter, gauss_falls_to_exp_minus_eighteen_at_the_border) {
    const PixelFilter filter(FilterType::kGauss, 1.5F);
    EXPECT_FLOAT_EQ(filter.weight(0), 1);
    EXPECT_NEAR(filter.weight(1.125F), std::exp(-4.5F), 1e-6F);
}

struct Support {
    FilterType type;
    float half;  // of a filter of width 1
};
constexpr Support kSupports[] = {
    {FilterType::kBlackmanHarris, 1}, {FilterType::kGauss, 1.5F}, {FilterType::kBox, 0.5F}};

TEST(pixel_filter, weights_end_at_the_support) {
    for (const auto& [type, half] : kSupports) {
        EXPECT_GT(PixelFilter(type, 1).weight(0.99F * half), 0);
        EXPECT_EQ(PixelFilter(type, 1).weight(1.01F * half), 0);
        EXPECT_EQ(PixelFilter(type, 1).weight(-1.01F * half), 0);
    }
}

// Cycles 3.4, 4096 samples, on a bright half plane whose edge runs through the middle of a pixel: what the next pixel
// on the dark side has.
TEST(pixel_filter, an_edge_is_as_soft_as_in_cycles) {
    const auto beyond = [](FilterType type, float edge) {
        const PixelFilter filter(type, 1.5F);
        int count = 0;
        constexpr int kSteps = 100000;
        for (int step = 0; step < kSteps; ++step) {
            count += filter.sample((static_cast<float>(step) + 0.5F) / kSteps) > edge;
        }
        return static_cast<float>(count) / kSteps;
    };
    EXPECT_NEAR(beyond(FilterType::kBlackmanHarris, 1), 0.0063F, 6e-4F);
    EXPECT_NEAR(beyond(FilterType::kGauss, 1), 0.0044F, 6e-4F);
}

TEST(pixel_filter, samples_have_the_filters_mean_and_variance) {
    for (const auto& [type, half] : kSupports) {
        const PixelFilter filter(type, 1.5F);
        const double variance = integral(filter, 2) / integral(filter, 0);
        double sum = 0;
        double squares = 0;
        constexpr int kPixels = 200;
        constexpr int kSamples = 64;
        for (int pixel = 0; pixel < kPixels; ++pixel) {
            for (int index = 0; index < kSamples; ++index) {
                const Vec2 offset = filter.offset(pixel, index);
                EXPECT_LE(std::abs(offset.x), 1.5F * half);
                EXPECT_LE(std::abs(offset.y), 1.5F * half);
                sum += offset.x + offset.y;
                squares += offset.x * offset.x + offset.y * offset.y;
            }
        }
        constexpr double kCount = 2.0 * kPixels * kSamples;
        EXPECT_NEAR(sum / kCount, 0, 1e-3);
        // The outermost steps of the table stretch the tails of the Gaussian by 2 %.
        EXPECT_NEAR(squares / kCount, variance, 0.02 * variance);
    }
}

TEST(pixel_filter, sample_inverts_the_cumulative_weight) {
    const PixelFilter filter(FilterType::kBlackmanHarris, 1.5F);
    EXPECT_NEAR(filter.sample(0.5F), 0, 1e-4F);
    EXPECT_NEAR(filter.sample(0), -1.5F, 1e-3F);
    EXPECT_NEAR(filter.sample(1), 1.5F, 1e-3F);
    for (float u = 0.1F; u < 0.5F; u += 0.1F) {
        EXPECT_NEAR(filter.sample(u), -filter.sample(1 - u), 1e-4F);
        EXPECT_LT(filter.sample(u), filter.sample(u + 0.1F));
    }
    EXPECT_NEAR(PixelFilter(FilterType::kBox, 2).sample(0.75F), 0.5F, 1e-3F);
}

TEST(pixel_filter, sixteen_samples_fill_every_stratum) {
    const PixelFilter box(FilterType::kBox, 1);
    for (int pixel = 0; pixel < 50; ++pixel) {
        std::vector<int> squares(16, 0), columns(16, 0), rows(16, 0);
        for (int index = 0; index < 16; ++index) {
            const Vec2 place = box.offset(pixel, index) + Vec2(0.5F);
            ++squares[4 * static_cast<int>(4 * place.y) + static_cast<int>(4 * place.x)];
            ++columns[static_cast<int>(16 * place.x)];
            ++rows[static_cast<int>(16 * place.y)];
        }
        EXPECT_EQ(squares, std::vector<int>(16, 1));
        EXPECT_EQ(columns, std::vector<int>(16, 1));
        EXPECT_EQ(rows, std::vector<int>(16, 1));
    }
}

}  // namespace
}  // namespace gg
