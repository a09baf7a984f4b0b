// Pixels of an image file, as they are stored.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace gg {

struct ImageHeader {
    std::uint32_t width = 0, height = 0;
    bool bytes = false;  // 8 bits a channel
};

// (height, width, 3) RGB, bottom row first, still encoded as in the file; alpha is multiplied in. Grey is repeated.
struct RawImage {
    ImageHeader header;
    std::vector<std::uint8_t> bytes;  // when header.bytes
    std::vector<float> floats;        // else; may hold NaN and infinities
};

// Throw Error with a sentence when there is no file, no known format, or the content is damaged.
[[nodiscard]] ImageHeader read_image_header(const std::string& path);
[[nodiscard]] RawImage read_image(const std::string& path);

}  // namespace gg
