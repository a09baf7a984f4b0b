#include "image/texel_codec.h"

#include <array>

namespace gg {

namespace {

std::array<float, 256> decoding_table(bool srgb) {
    std::array<float, 256> table{};
    for (int byte = 0; byte < 256; ++byte) {
        const float encoded = static_cast<float>(byte) / 255.0F;
        table[byte] = srgb ? srgb_to_linear(encoded) : encoded;
    }
    return table;
}

// sRGB encoding by search, since a power function per texel would take longer than reading the file: the range [0, 1]
// is cut into bins, each knows the byte of its lower end, and at most a few bytes start within a bin.
struct SrgbEncoding {
    static constexpr int kBins = 4096;
    std::array<float, 257> begin{};  // least linear value that rounds to the byte
    std::array<std::uint8_t, kBins + 1> first{};

    SrgbEncoding() {
        for (int byte = 1; byte < 256; ++byte) {
            begin[byte] = srgb_to_linear((static_cast<float>(byte) - 0.5F) / 255.0F);
        }
        begin[256] = 2;
        int byte = 0;
        for (int bin = 0; bin <= kBins; ++bin) {
            while (begin[byte + 1] <= static_cast<float>(bin) / kBins) {
                ++byte;
            }
            first[bin] = static_cast<std::uint8_t>(byte);
        }
    }
};

}  // namespace

const float* byte_decoding(bool srgb) {
    static const std::array<float, 256> kTables[2] = {decoding_table(false), decoding_table(true)};
    return kTables[srgb ? 1 : 0].data();
}

std::uint8_t encode_byte(float linear, bool srgb) {
    const float value = linear > 0 ? std::min(linear, 1.0F) : 0.0F;
    if (!srgb) {
        return static_cast<std::uint8_t>(value * 255.0F + 0.5F);
    }
    static const SrgbEncoding kEncoding;
    int byte = kEncoding.first[static_cast<int>(value * SrgbEncoding::kBins)];
    while (kEncoding.begin[byte + 1] <= value) {
        ++byte;
    }
    return static_cast<std::uint8_t>(byte);
}

}  // namespace gg
