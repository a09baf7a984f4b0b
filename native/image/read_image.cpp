#include "image/read_image.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <memory>

#include "core/error.h"

namespace gg {

namespace {

// Damaged headers claim absurd sizes: this is 23,000 pixels square, and a byte image of 1.6 GB.
constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 29;

// Messages are one line.
[[noreturn]] void fail(const std::string& reason) {
    const std::string line = reason.substr(0, reason.find('\n'));
    throw Error(GG_INVALID_SCENE, line.empty() ? "unknown reason" : line);
}

std::unique_ptr<OIIO::ImageInput> open_image(const std::string& path) {
    auto input = OIIO::ImageInput::open(path);
    if (!input) {
        fail(OIIO::geterror());
    }
    return input;
}

ImageHeader checked_header(const OIIO::ImageSpec& spec) {
    if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0) {
        fail("it has no pixels");
    }
    if (static_cast<std::uint64_t>(spec.width) * static_cast<std::uint64_t>(spec.height) > kMostPixels) {
        fail("its size is " + std::to_string(spec.width) + " x " + std::to_string(spec.height));
    }
    return {static_cast<std::uint32_t>(spec.width), static_cast<std::uint32_t>(spec.height),
            spec.format == OIIO::TypeDesc::UINT8};
}

// Grey (1) and grey with alpha (2 channels) to RGB.
template <typename T>
std::vector<T> repeat_first_channel(const std::vector<T>& values, std::size_t channels) {
    std::vector<T> rgb;
    rgb.reserve(values.size() / channels * 3);
    for (std::size_t index = 0; index < values.size(); index += channels) {
        rgb.insert(rgb.end(), 3, values[index]);
    }
    return rgb;
}

template <typename T>
std::vector<T> read_rgb(OIIO::ImageInput& input, const ImageHeader& header, OIIO::TypeDesc type) {
    const int channels = std::min(input.spec().nchannels, 3);
    const std::size_t row = std::size_t{header.width} * channels;
    std::vector<T> values(row * header.height);
    // Files start at the top: a negative stride puts the bottom row first.
    if (!input.read_image(0, 0, 0, channels, type, values.data() + row * (header.height - 1), OIIO::AutoStride,
                          -static_cast<OIIO::stride_t>(row * sizeof(T)))) {
        fail(input.geterror());
    }
    return channels == 3 ? values : repeat_first_channel(values, static_cast<std::size_t>(channels));
}

}  // namespace

ImageHeader read_image_header(const std::string& path) {
    return checked_header(open_image(path)->spec());
}

RawImage read_image(const std::string& path) {
    const auto input = open_image(path);
    RawImage image;
    image.header = checked_header(input->spec());
    if (image.header.bytes) {
        image.bytes = read_rgb<std::uint8_t>(*input, image.header, OIIO::TypeDesc::UINT8);
    } else {
        image.floats = read_rgb<float>(*input, image.header, OIIO::TypeDesc::FLOAT);
    }
    return image;
}

}  // namespace gg
