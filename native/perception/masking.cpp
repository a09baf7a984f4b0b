#include "perception/masking.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/parallel.h"
#include "perception/csf.h"
#include "perception/luminance_pyramid.h"
#include "perception/tvi.h"

namespace gg {

namespace {

constexpr int kBands = 6;               // at most
constexpr float kLowestFrequency = 16;  // cycles/degree: coarser ones, as of soft light and of lone edges, hide little
constexpr int kLevels = kBands + 2;     // each band's contrast is that of two levels over a third one
constexpr float kUnseen = 1 / kPeakSensitivity;  // contrast, in sum over all bands, that nobody sees
constexpr std::size_t kRows = 8;

// The level of which a sample stands for about a degree.
int adaptation_level(float pixels_per_degree) {
    return std::clamp(static_cast<int>(std::lround(std::log2(std::max(pixels_per_degree, 1.0F)))), 0, kLevels - 1);
}

// Octaves that hide something: halves of the finest that the picture can show.
int bands_of(const Viewing& viewing) {
    int bands = 1;
    while (bands < kBands && viewing.pixels_per_degree / static_cast<float>(2 << bands) >= kLowestFrequency) {
        ++bands;
    }
    return bands;
}

// Sensitivity to the bands' frequencies, by adaptation: it changes slowly, and there are many pixels.
class Sensitivities {
  public:
    Sensitivities(int bands, float pixels_per_degree) : bands_(bands) {
        for (int i = 0; i < kCount; ++i) {
            const float adaptation = std::exp2(kLeast + static_cast<float>(i) / kPerOctave);
            for (int band = 0; band < bands; ++band) {
                values_[i][band] = contrast_sensitivity(pixels_per_degree / static_cast<float>(2 << band), adaptation);
            }
        }
    }

    // Of all bands; linear in between.
    [[nodiscard]] std::array<float, kBands> at(float adaptation) const {
        const float place = std::clamp((std::log2(adaptation) - kLeast) * kPerOctave, 0.0F, kCount - 1.001F);
        const int i = static_cast<int>(place);
        std::array<float, kBands> mixed{};
        for (int band = 0; band < bands_; ++band) {
            mixed[band] = std::lerp(values_[i][band], values_[i + 1][band], place - static_cast<float>(i));
        }
        return mixed;
    }

  private:
    static constexpr int kCount = 241;
    static constexpr float kLeast = -17, kPerOctave = 8;  // 2^-17..2^13 cd/m2
    int bands_;
    std::array<std::array<float, kBands>, kCount> values_{};
};

}  // namespace

float contrast_elevation(float visible) {
    // W = 6, Q = 0.7, b = 4, and a slope of 0.7 for all bands.
    constexpr float k1 = 0.015287F, k2 = 392.498F, slope = 0.7F;
    const float x = k1 * std::pow(k2 * visible, slope);
    return std::sqrt(std::sqrt(1 + x * x * x * x));
}

MaskingMap masking_map(std::uint32_t width, std::uint32_t height, std::vector<float> luminance, const Viewing& viewing,
                       const Control& control) {
    const int bands = bands_of(viewing), adapts = adaptation_level(viewing.pixels_per_degree);
    const LuminancePyramid pyramid(width, height, std::move(luminance), std::max(bands + 2, adapts + 1), control);
    const Sensitivities sensitivities(bands, viewing.pixels_per_degree);
    MaskingMap map{width, height, {}, {}};
    map.adaptation.resize(std::size_t{width} * height);
    map.elevation.resize(map.adaptation.size());
    parallel_blocks(height, kRows, control, [&](std::size_t begin, std::size_t end) {
        std::array<std::vector<float>, kLevels> rows;
        for (std::size_t y = begin; y < end; ++y) {
            for (int level = 0; level < pyramid.level_count(); ++level) {
                if (level < bands + 2 || level == adapts) {
                    pyramid.stretched_row(level, static_cast<std::uint32_t>(y), rows[level]);
                }
            }
            for (std::size_t x = 0; x < width; ++x) {
                const float adaptation = std::max(rows[adapts][x], kDarkestAdaptation);
                const std::array<float, kBands> sensitivity = sensitivities.at(adaptation);
                // Where there is next to no contrast, nothing hides anything.
                float elevated = kUnseen, all = kUnseen;
                for (int band = 0; band < bands; ++band) {
                    const float contrast =
                        std::abs(rows[band][x] - rows[band + 1][x]) / std::max(rows[band + 2][x], kDarkestAdaptation);
                    elevated += contrast * contrast_elevation(contrast * sensitivity[band]);
                    all += contrast;
                }
                map.adaptation[y * width + x] = adaptation;
                map.elevation[y * width + x] = std::clamp(elevated / all, 1.0F, MaskingMap::kMost);
            }
        }
    });
    return map;
}

}  // namespace gg
