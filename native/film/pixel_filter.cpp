#include "film/pixel_filter.h"

#include <algorithm>
#include <vector>

#include "core/random.h"

namespace gg {

namespace {

// Bit-reversed van der Corput sequence and the second dimension of Sobol's.
std::uint32_t reverse_bits(std::uint32_t x) {
    x = ((x >> 1) & 0x55555555U) | ((x & 0x55555555U) << 1);
    x = ((x >> 2) & 0x33333333U) | ((x & 0x33333333U) << 2);
    x = ((x >> 4) & 0x0f0f0f0fU) | ((x & 0x0f0f0f0fU) << 4);
    x = ((x >> 8) & 0x00ff00ffU) | ((x & 0x00ff00ffU) << 8);
    return (x >> 16) | (x << 16);
}

std::uint32_t sobol_second(std::uint32_t index) {
    std::uint32_t result = 0;
    for (std::uint32_t direction = 1U << 31; index != 0; index >>= 1, direction ^= direction >> 1) {
        result ^= index & 1U ? direction : 0;
    }
    return result;
}

// Each bit is flipped by a hash of the bits above it: the hash of [Burley 2020, section 3] on the reversed word.
std::uint32_t owen_scramble(std::uint32_t x, std::uint32_t seed) {
    x = reverse_bits(x) + seed;
    x ^= x * 0x6c50b47cU;
    x ^= x * 0xb82f1e52U;
    x ^= x * 0xc7afe638U;
    x ^= x * 0x8d22f6e6U;
    return reverse_bits(x);
}

// Full support over the width that Cycles' users set.
float support_in_widths(FilterType type) {
    switch (type) {
        case FilterType::kBlackmanHarris:
            return 2;
        case FilterType::kGauss:
            return 3;
        case FilterType::kBox:
            return 1;
    }
    return 1;
}

float to_unit(std::uint32_t bits) {
    return static_cast<float>(bits >> 8) * 0x1p-24F;
}

}  // namespace

PixelFilter::PixelFilter(FilterType type, float width) : type_(type), support_(width * support_in_widths(type)) {
    constexpr int kSteps = 8 * kTable;
    std::vector<double> cumulative(kSteps + 1, 0.0);
    const auto place = [&](double step) { return support_ * static_cast<float>(step / kSteps - 0.5); };
    for (int step = 0; step < kSteps; ++step) {
        cumulative[step + 1] = cumulative[step] + static_cast<double>(weight(place(step + 0.5)));
    }
    int step = 0;
    for (int entry = 0; entry <= kTable; ++entry) {
        const double wanted = cumulative[kSteps] * entry / kTable;
        while (step + 1 < kSteps && cumulative[step + 1] < wanted) {
            ++step;
        }
        const double inside = (wanted - cumulative[step]) / std::max(cumulative[step + 1] - cumulative[step], 1e-30);
        inverse_[entry] = place(step + std::clamp(inside, 0.0, 1.0));
    }
}

float PixelFilter::weight(float x) const {
    if (std::abs(x) > 0.5F * support_) {
        return 0;
    }
    switch (type_) {
        case FilterType::kBlackmanHarris: {
            const float phase = 2 * kPi * (x / support_ + 0.5F);
            return 0.35875F - 0.48829F * std::cos(phase) + 0.14128F * std::cos(2 * phase) -
                   0.01168F * std::cos(3 * phase);
        }
        case FilterType::kGauss: {
            const float scaled = 6 * x / support_;
            return std::exp(-2 * scaled * scaled);
        }
        case FilterType::kBox:
            return 1;
    }
    return 0;
}

float PixelFilter::sample(float u) const {
    const float place = std::clamp(u, 0.0F, 1.0F) * kTable;
    const int entry = std::min(static_cast<int>(place), kTable - 1);
    const float share = place - static_cast<float>(entry);
    return (1 - share) * inverse_[entry] + share * inverse_[entry + 1];
}

Vec2 PixelFilter::offset(std::uint64_t pixel, std::uint32_t index) const {
    const std::uint64_t seed = hash64(pixel);
    const std::uint32_t x = owen_scramble(reverse_bits(index), static_cast<std::uint32_t>(seed));
    const std::uint32_t y = owen_scramble(sobol_second(index), static_cast<std::uint32_t>(seed >> 32));
    return {sample(to_unit(x)), sample(to_unit(y))};
}

}  // namespace gg
