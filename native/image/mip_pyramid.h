// An image in all resolutions down to one texel, filtered in linear light.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/vec.h"
#include "image/read_image.h"
#include "image/texel_codec.h"

namespace gg {

struct MipLevel {
    std::uint32_t width = 0, height = 0;
    std::size_t offset = 0;  // of its first value; 3 values a texel, bottom row first
};

// Every level is the area average of the finest. Texels are bytes when the source's are, which a table decodes, else
// half floats in linear light.
struct MipPyramid {
    std::vector<MipLevel> levels;  // finest first, last 1x1
    std::vector<std::uint8_t> bytes;
    std::vector<std::uint16_t> halves;
    const float* decoding = nullptr;  // of bytes; null: halves are used

    [[nodiscard]] Rgb texel(const MipLevel& level, std::uint32_t x, std::uint32_t y) const {
        const std::size_t at = level.offset + 3 * (std::size_t{y} * level.width + x);
        if (decoding != nullptr) {
            return {decoding[bytes[at]], decoding[bytes[at + 1]], decoding[bytes[at + 2]]};
        }
        return {half_to_float(halves[at]), half_to_float(halves[at + 1]), half_to_float(halves[at + 2])};
    }
    [[nodiscard]] std::size_t memory_bytes() const { return bytes.size() + 2 * halves.size(); }
};

// srgb: the image's values are sRGB encoded. NaN and infinities become 0.
// The finest `dropped` levels are left out (but never the last).
[[nodiscard]] MipPyramid make_mip_pyramid(RawImage&& image, bool srgb, std::uint32_t dropped);

// memory_bytes() of such a pyramid.
[[nodiscard]] std::size_t pyramid_bytes(const ImageHeader& header, std::uint32_t dropped);

}  // namespace gg
