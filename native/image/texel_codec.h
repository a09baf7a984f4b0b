// How texels are stored: bytes, sRGB encoded or linear, and half floats.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace gg {

// [IEC 61966-2-1], extended to all x: an odd function.
[[nodiscard]] inline float srgb_to_linear(float encoded) {
    const float x = std::abs(encoded);
    return std::copysign(x <= 0.04045F ? x / 12.92F : std::pow((x + 0.055F) / 1.055F, 2.4F), encoded);
}

inline constexpr float kLargestHalf = 65504;

// Half float to float. Exponents differ in bias by 112, so that a shift and one exact product do it, denormals too.
[[nodiscard]] inline float half_to_float(std::uint16_t half) {
    const float magnitude = std::bit_cast<float>((half & 0x7fffU) << 13) * 0x1p112F;
    return half & 0x8000U ? -magnitude : magnitude;
}

// Nearest half float; beyond its range the largest finite one; 0 for NaN.
[[nodiscard]] inline std::uint16_t float_to_half(float value) {
    const float magnitude = std::min(std::abs(value), kLargestHalf);
    if (!(magnitude >= 0)) {
        return 0;
    }
    const auto bits = std::bit_cast<std::uint32_t>(magnitude * 0x1p-112F);
    const std::uint32_t rounded = (bits + 0xfffU + ((bits >> 13) & 1U)) >> 13;
    return static_cast<std::uint16_t>(rounded | (std::signbit(value) ? 0x8000U : 0U));
}

// 256 linear values of the bytes.
[[nodiscard]] const float* byte_decoding(bool srgb);

// The byte whose encoded value is nearest to that of the linear value, which is clamped to [0, 1].
[[nodiscard]] std::uint8_t encode_byte(float linear, bool srgb);

}  // namespace gg
