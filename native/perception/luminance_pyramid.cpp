#include "perception/luminance_pyramid.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/parallel.h"

namespace gg {

namespace {

constexpr std::array<float, 5> kWeights{0.05F, 0.25F, 0.4F, 0.25F, 0.05F};  // of neighbours that are 2, 1, 0 apart
constexpr std::size_t kRows = 32;

// Of sample i + apart, the last one going on beyond the border.
std::size_t beside(std::size_t i, int apart, std::size_t count) {
    const auto moved = static_cast<std::ptrdiff_t>(i) + apart;
    return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(moved, 0, static_cast<std::ptrdiff_t>(count) - 1));
}

}  // namespace

LuminancePyramid::LuminancePyramid(std::uint32_t width, std::uint32_t height, std::vector<float> values, int levels,
                                   const Control& control) {
    levels_.push_back({width, height, std::move(values)});
    while (level_count() < levels) {
        levels_.push_back(halved(levels_.back(), control));
    }
}

LuminancePyramid::Level LuminancePyramid::halved(const Level& level, const Control& control) {
    Level half{(level.width + 1) / 2, (level.height + 1) / 2, {}};
    half.values.resize(std::size_t{half.width} * half.height);
    parallel_blocks(half.height, kRows, control, [&](std::size_t begin, std::size_t end) {
        std::vector<float> mixed(level.width);  // of five rows
        for (std::size_t y = begin; y < end; ++y) {
            std::fill(mixed.begin(), mixed.end(), 0.0F);
            for (int k = 0; k < 5; ++k) {
                const float* row = &level.values[beside(2 * y, k - 2, level.height) * level.width];
                for (std::size_t x = 0; x < level.width; ++x) {
                    mixed[x] += kWeights[k] * row[x];
                }
            }
            for (std::size_t x = 0; x < half.width; ++x) {
                float sum = 0;
                for (int k = 0; k < 5; ++k) {
                    sum += kWeights[k] * mixed[beside(2 * x, k - 2, level.width)];
                }
                half.values[y * half.width + x] = sum;
            }
        }
    });
    return half;
}

void LuminancePyramid::stretched_row(int level, std::uint32_t row, std::vector<float>& values) const {
    const Level& from = levels_[static_cast<std::size_t>(level)];
    const std::uint32_t width = levels_.front().width, step = 1U << level;
    const std::uint32_t below = row / step, above = std::min(below + 1, from.height - 1);
    const float up = static_cast<float>(row % step) / static_cast<float>(step);
    const float* low = &from.values[std::size_t{below} * from.width];
    const float* high = &from.values[std::size_t{above} * from.width];
    values.resize(width);
    const auto at = [&](std::uint32_t x) { return low[x] + up * (high[x] - low[x]); };
    float left = at(0);
    for (std::uint32_t x = 0; x < from.width; ++x) {
        const float right = at(std::min(x + 1, from.width - 1));
        const std::uint32_t begin = x * step, end = std::min(begin + step, width);
        for (std::uint32_t i = begin; i < end; ++i) {
            values[i] = left + (right - left) * static_cast<float>(i - begin) / static_cast<float>(step);
        }
        left = right;
    }
}

}  // namespace gg
