#include "film/pixel_filter.h"

#include <gtest/gtest.h>

#include <vector>

namespace gg {
namespace {

double integral(const PixelFilter& filter, int power) {
    double sum = 0;
    constexpr int kSteps = 20000;
    for (int step = 0; step < kSteps; ++step) {
        const double x = 4.0 * (step + 0.5) / kSteps - 2;
        sum += static_cast<double>(filter.weight(static_cast<float>(x))) * std::pow(x, power);
    }
    return sum * 4.0 / kSteps;
}

TEST(pixel_filter, blackman_harris_integrates_to_its_constant_term) {
    EXPECT_NEAR(integral(PixelFilter(FilterType::kBlackmanHarris, 1.5F), 0), 1.5 * 0.35875, 1e-4);
    EXPECT_NEAR(PixelFilter(FilterType::kBlackmanHarris, 1.5F).weight(0), 1, 1e-6);
    EXPECT_NEAR(PixelFilter(FilterType::kBlackmanHarris, 1.5F).weight(0.75F), 0.00006, 1e-5);
}

TEST(pixel_filter, gauss_falls_to_exp_minus_eighteen_at_the_border) {
    const PixelFilter filter(FilterType::kGauss, 1.5F);
    EXPECT_FLOAT_EQ(filter.weight(0), 1);
    EXPECT_NEAR(filter.weight(0.375F), std::exp(-4.5F), 1e-6F);
}

TEST(pixel_filter, weights_end_at_the_support) {
    for (const FilterType type : {FilterType::kBlackmanHarris, FilterType::kGauss, FilterType::kBox}) {
        EXPECT_EQ(PixelFilter(type, 1).weight(0.51F), 0);
        EXPECT_EQ(PixelFilter(type, 1).weight(-0.51F), 0);
    }
}

TEST(pixel_filter, samples_have_the_filters_mean_and_variance) {
    for (const FilterType type : {FilterType::kBlackmanHarris, FilterType::kGauss, FilterType::kBox}) {
        const PixelFilter filter(type, 1.5F);
        const double variance = integral(filter, 2) / integral(filter, 0);
        double sum = 0;
        double squares = 0;
        constexpr int kPixels = 200;
        constexpr int kSamples = 64;
        for (int pixel = 0; pixel < kPixels; ++pixel) {
            for (int index = 0; index < kSamples; ++index) {
                const Vec2 offset = filter.offset(pixel, index);
                EXPECT_LE(std::abs(offset.x), 0.75F);
                EXPECT_LE(std::abs(offset.y), 0.75F);
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
    EXPECT_NEAR(filter.sample(0), -0.75F, 1e-3F);
    EXPECT_NEAR(filter.sample(1), 0.75F, 1e-3F);
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
