#include "perception/masking.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>

#include "core/control.h"
#include "core/parallel.h"
#include "core/random.h"
#include "perception/csf.h"

namespace gg::test {
namespace {

constexpr std::uint32_t kSide = 1025;

template <typename Luminance>
std::vector<float> picture(const Luminance& luminance) {
    std::vector<float> values(std::size_t{kSide} * kSide);
    for (std::uint32_t y = 0; y < kSide; ++y) {
        for (std::uint32_t x = 0; x < kSide; ++x) {
            values[std::size_t{y} * kSide + x] = luminance(x, y);
        }
    }
    return values;
}

MaskingMap map_of(std::vector<float> values) {
    return masking_map(kSide, kSide, std::move(values), {}, Control());
}

float texture(std::uint32_t x, std::uint32_t y) {
    return 40 + 8 * (static_cast<float>(hash64(x, y) >> 40) / static_cast<float>(1 << 24) - 0.5F) +
           3 * std::sin(0.07F * static_cast<float>(x)) * std::sin(0.05F * static_cast<float>(y));
}

// The same pyramid at full resolution: weights that stand further and further apart.
std::array<std::vector<float>, 8> smoothed(std::vector<float> values) {
    std::array<std::vector<float>, 8> levels;
    levels[0] = std::move(values);
    for (int level = 1; level < 8; ++level) {
        std::vector<float> along(levels[0].size());
        const int step = 1 << (level - 1), side = static_cast<int>(kSide);
        const auto mix = [&](const std::vector<float>& from, int dx, int dy) {
            std::vector<float> mixed(from.size());
            for (int y = 0; y < side; ++y) {
                for (int x = 0; x < side; ++x) {
                    for (int k = -2; k <= 2; ++k) {
                        const int i = std::clamp(x + k * dx, 0, side - 1), j = std::clamp(y + k * dy, 0, side - 1);
                        const float weight = k == 0 ? 0.4F : (std::abs(k) == 1 ? 0.25F : 0.05F);
                        mixed[static_cast<std::size_t>(y * side + x)] +=
                            weight * from[static_cast<std::size_t>(j * side + i)];
                    }
                }
            }
            return mixed;
        };
        levels[level] = mix(mix(levels[level - 1], step, 0), 0, step);
    }
    return levels;
}

TEST(Masking, contrast_raises_thresholds_by_known_factors) {
    for (const auto& [contrast, factor] :
         {std::pair(0.0F, 1.0F), {1.0F, 1.190F}, {3.0F, 2.184F}, {10.0F, 5.018F}, {30.0F, 10.82F}, {100.0F, 25.14F}}) {
        EXPECT_NEAR(contrast_elevation(contrast), factor, 1e-3F * factor) << contrast;
    }
}

TEST(Masking, even_pictures_hide_nothing) {
    const MaskingMap map = map_of(std::vector<float>(std::size_t{kSide} * kSide, 50.0F));
    for (std::size_t i = 0; i < map.elevation.size(); ++i) {
        ASSERT_EQ(map.elevation[i], 1) << i;
        ASSERT_NEAR(map.adaptation[i], 50, 1e-3F) << i;
    }
}

// Where samples of all levels lie on a pixel, its elevation is that of the formulas on a pyramid without halving.
TEST(Masking, is_that_of_a_pyramid_at_full_resolution) {
    struct View {
        float pixels_per_degree;
        int bands, adapts;  // octaves that hide something, and the level of about a degree
    };
    const std::vector<float> values = picture(texture);
    const auto levels = smoothed(values);
    for (const auto& [pixels_per_degree, bands, adapts] : {View{40, 1, 5}, {64, 2, 6}}) {
        Viewing viewing;
        viewing.pixels_per_degree = pixels_per_degree;
        const MaskingMap map = masking_map(kSide, kSide, values, viewing, Control());
        float largest = 0;
        for (std::uint32_t y = 512; y <= 640; y += 128) {
            for (std::uint32_t x = 384; x <= 640; x += 128) {
                const std::size_t i = std::size_t{y} * kSide + x;
                const float adaptation = levels[adapts][i];
                EXPECT_NEAR(map.adaptation[i], adaptation, 1e-4F * adaptation);
                float sum = 1 / 525.15F, all = sum;
                for (int band = 0; band < bands; ++band) {
                    const float frequency = pixels_per_degree / static_cast<float>(2 << band);
                    const float contrast = std::abs(levels[band][i] - levels[band + 1][i]) / levels[band + 2][i];
                    sum += contrast * contrast_elevation(contrast * contrast_sensitivity(frequency, adaptation));
                    all += contrast;
                }
                const float expected = std::min(sum / all, 10.0F);
                EXPECT_NEAR(map.elevation[i], expected, 2e-3F * expected);
                largest = std::max(largest, map.elevation[i]);
            }
        }
        EXPECT_GT(largest, 1.2F);
        EXPECT_LT(largest, 10);
    }
}

TEST(Masking, stays_within_its_bounds) {
    const MaskingMap map =
        map_of(picture([](std::uint32_t x, std::uint32_t y) { return x % 2 == y % 2 ? 100.0F : 0.0F; }));
    for (const float elevation : map.elevation) {
        ASSERT_GE(elevation, 1);
        ASSERT_LE(elevation, MaskingMap::kMost);
    }
    EXPECT_EQ(map.elevation[std::size_t{500} * kSide + 500], MaskingMap::kMost);
}

// Half a picture is patterned: its other half, beyond a degree from there, hides nothing.
TEST(Masking, hides_only_where_the_pattern_is) {
    const MaskingMap map =
        map_of(picture([](std::uint32_t x, std::uint32_t y) { return x < kSide / 2 ? texture(x, y) : 40.0F; }));
    double patterned = 0, plain = 0;
    for (std::uint32_t y = 200; y < 800; ++y) {
        for (std::uint32_t x = 0; x < 200; ++x) {
            patterned += static_cast<double>(map.elevation[std::size_t{y} * kSide + 100 + x]) / (600 * 200);
            plain += static_cast<double>(map.elevation[std::size_t{y} * kSide + 800 + x]) / (600 * 200);
        }
    }
    EXPECT_GT(patterned, 1.7);
    EXPECT_LT(plain, 1.05);
}

// Light that changes slowly hides nothing.
TEST(Masking, needs_fine_patterns) {
    const MaskingMap map =
        map_of(picture([](std::uint32_t x, std::uint32_t) { return 40 + 10 * std::sin(static_cast<float>(x) / 40); }));
    for (std::uint32_t x = 200; x < 800; ++x) {
        EXPECT_LT(map.elevation[std::size_t{500} * kSide + x], 1.6F) << x;  // waves of 6 degrees
    }
}

// From afar a degree has more pixels: adaptation is that of more of them, and single pixels hide less.
TEST(Masking, depends_on_the_distance) {
    const std::vector<float> values =
        picture([](std::uint32_t x, std::uint32_t) { return x < kSide / 2 ? 20.0F : 80.0F; });
    Viewing close, far;
    close.pixels_per_degree = 8;
    far.pixels_per_degree = 64;
    const std::size_t beside = std::size_t{500} * kSide + kSide / 2 + 20;
    EXPECT_NEAR(masking_map(kSide, kSide, values, close, Control()).adaptation[beside], 80, 0.5F);
    EXPECT_LT(masking_map(kSide, kSide, values, far, Control()).adaptation[beside], 75);
}

TEST(Masking, is_the_same_for_any_number_of_threads) {
    const std::vector<float> values = picture(texture);
    const MaskingMap all = map_of(values);
    MaskingMap one;
    run_with_threads(1, [&] { one = map_of(values); });
    EXPECT_EQ(all.elevation, one.elevation);
    EXPECT_EQ(all.adaptation, one.adaptation);
}

TEST(Masking, stops_when_cancelled) {
    Control control;
    control.cancel();
    EXPECT_THROW((void)masking_map(kSide, kSide, picture(texture), {}, control), Cancelled);
}

}  // namespace
}  // namespace gg::test
