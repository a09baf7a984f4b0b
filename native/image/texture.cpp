#include "image/texture.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <exception>
#include <queue>
#include <utility>

#include "core/control.h"
#include "core/messages.h"
#include "core/parallel.h"
#include "image/read_image.h"

namespace gg {

namespace {

// Blender hands the pixels of byte images over as floats: they fit into bytes without loss.
bool fits_bytes(const ImageSource& source) {
    return std::all_of(source.pixels.begin(), source.pixels.end(), [](float value) {
        const float scaled = value * 255.0F;
        return scaled >= -1e-3F && scaled <= 255.001F && std::abs(scaled - std::round(scaled)) < 1e-3F;
    });
}

bool pixels_fit_size(const ImageSource& source) {
    return source.width > 0 && source.height > 0 &&
           source.pixels.size() == std::size_t{source.width} * source.height * 4;
}

RawImage raw_image_of_pixels(const ImageSource& source, bool bytes) {
    RawImage image;
    image.header = {source.width, source.height, bytes};
    for (std::size_t index = 0; index < source.pixels.size(); ++index) {
        if (index % 4 == 3) {
            continue;
        }
        if (bytes) {
            image.bytes.push_back(static_cast<std::uint8_t>(source.pixels[index] * 255.0F + 0.5F));
        } else {
            image.floats.push_back(source.pixels[index]);
        }
    }
    return image;
}

RawImage magenta() {
    RawImage image;
    image.header = {1, 1, true};
    image.bytes = {255, 0, 255};
    return image;
}

// What is known of an image before its pixels are read. `error` is empty when it can be read.
struct Plan {
    ImageHeader header;
    std::uint32_t dropped = 0;  // finest levels
    std::string error;
};

Plan plan_image(const ImageSource& source) {
    Plan plan;
    try {
        if (!source.path.empty()) {
            plan.header = read_image_header(source.path);
        } else if (pixels_fit_size(source)) {
            plan.header = {source.width, source.height, fits_bytes(source)};
        } else {
            plan.error = "it has no pixels";
        }
    } catch (const std::exception& error) {
        plan.error = error.what();
    }
    return plan;
}

void fit_into_memory(std::vector<Plan>& plans, std::size_t memory_limit) {
    using Entry = std::pair<std::size_t, std::size_t>;  // bytes, index
    std::priority_queue<Entry> largest;
    std::size_t total = 0;
    for (std::size_t index = 0; index < plans.size(); ++index) {
        if (plans[index].error.empty()) {
            const std::size_t bytes = pyramid_bytes(plans[index].header, 0);
            largest.emplace(bytes, index);
            total += bytes;
        }
    }
    while (total > memory_limit && !largest.empty()) {
        const auto [bytes, index] = largest.top();
        largest.pop();
        const std::size_t smaller = pyramid_bytes(plans[index].header, ++plans[index].dropped);
        if (smaller == bytes) {  // a single texel is left of the largest: so it is of all
            --plans[index].dropped;
            break;
        }
        total -= bytes - smaller;
        largest.emplace(smaller, index);
    }
}

MipPyramid load(const ImageSource& source, Plan& plan) {
    if (plan.error.empty()) {
        try {
            return make_mip_pyramid(
                source.path.empty() ? raw_image_of_pixels(source, plan.header.bytes) : read_image(source.path),
                source.srgb, plan.dropped);
        } catch (const std::exception& error) {
            plan.error = error.what();
        }
    }
    return make_mip_pyramid(magenta(), true, 0);
}

// The two texels around a coordinate and the second one's weight.
struct Taps {
    std::uint32_t first = 0, second = 0;
    float weight = 0;
};

// coordinate in [0, 1].
Taps make_taps(float coordinate, std::uint32_t size, bool repeat) {
    const float at = coordinate * static_cast<float>(size) - 0.5F;
    const float below = std::floor(at);
    const auto last = static_cast<std::int64_t>(size) - 1;
    const auto first = static_cast<std::int64_t>(below);
    const auto wrapped = [&](std::int64_t texel) {
        if (texel < 0) {
            return static_cast<std::uint32_t>(repeat ? last : 0);
        }
        return static_cast<std::uint32_t>(texel > last ? (repeat ? 0 : last) : texel);
    };
    return {wrapped(first), wrapped(first + 1), at - below};
}

Rgb bilinear(const MipPyramid& pyramid, const MipLevel& level, Vec2 uv, bool repeat) {
    const Taps x = make_taps(uv.x, level.width, repeat);
    const Taps y = make_taps(uv.y, level.height, repeat);
    const Rgb lower =
        glm::mix(pyramid.texel(level, x.first, y.first), pyramid.texel(level, x.second, y.first), x.weight);
    const Rgb upper =
        glm::mix(pyramid.texel(level, x.first, y.second), pyramid.texel(level, x.second, y.second), x.weight);
    return glm::mix(lower, upper, y.weight);
}

Rgb nearest(const MipPyramid& pyramid, const MipLevel& level, Vec2 uv) {
    const auto index = [](float coordinate, std::uint32_t size) {
        return std::min(static_cast<std::uint32_t>(coordinate * static_cast<float>(size)), size - 1);
    };
    return pyramid.texel(level, index(uv.x, level.width), index(uv.y, level.height));
}

// Folds a coordinate into [0, 1].
float fold(float x, Wrap wrap) {
    switch (wrap) {
        case Wrap::kRepeat:
            return x - std::floor(x);
        case Wrap::kMirror: {
            const float period = x - 2.0F * std::floor(0.5F * x);
            return period > 1.0F ? 2.0F - period : period;
        }
        default:
            return std::clamp(x, 0.0F, 1.0F);
    }
}

// log2, but straight between powers of two: continuous, monotone, within 0.09, and nearly free.
float approximate_log2(float x) {
    return static_cast<float>(std::bit_cast<std::int32_t>(x)) * 0x1p-23F - 127.0F;
}

}  // namespace

TextureSet::TextureSet(std::span<const ImageSource> sources, const Control& control, Messages& messages,
                       std::size_t memory_limit)
    : textures_(sources.size()) {
    std::vector<Plan> plans(sources.size());
    parallel_for(sources.size(), 1, control, [&](std::size_t index) { plans[index] = plan_image(sources[index]); });
    fit_into_memory(plans, memory_limit);
    parallel_for(sources.size(), 1, control, [&](std::size_t index) {
        const ImageSource& source = sources[index];
        textures_[index] = {load(source, plans[index]), source.wrap, source.closest};
    });
    for (std::size_t index = 0; index < sources.size(); ++index) {
        if (!plans[index].error.empty()) {
            messages.add(sources[index].name, "Image cannot be read (" + plans[index].error + "): shown in magenta");
        } else if (plans[index].dropped > 0) {
            messages.add(sources[index].name,
                         "Image is used at a lower resolution: all images together exceed the limit of " +
                             std::to_string(memory_limit >> 20) + " MB");
        }
    }
}

Rgb TextureSet::lookup(std::uint32_t image, Vec2 uv, float width) const {
    const Texture& texture = textures_[image];
    const MipPyramid& pyramid = texture.pyramid;
    if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) {
        return Rgb(0);
    }
    if (texture.wrap == Wrap::kClip && (uv.x < 0 || uv.x > 1 || uv.y < 0 || uv.y > 1)) {
        return Rgb(0);
    }
    const Vec2 inside(fold(uv.x, texture.wrap), fold(uv.y, texture.wrap));
    const bool repeat = texture.wrap == Wrap::kRepeat;
    const MipLevel& finest = pyramid.levels.front();
    // The width is that of a square of the same area, and the image may be longer than it is high.
    const float texels = width * std::sqrt(static_cast<float>(finest.width) * static_cast<float>(finest.height));
    if (!(texels > 1.0F)) {
        return texture.closest ? nearest(pyramid, finest, inside) : bilinear(pyramid, finest, inside, repeat);
    }
    const float last = static_cast<float>(pyramid.levels.size() - 1);
    const float level = std::min(approximate_log2(texels), last);
    const auto lower = static_cast<std::size_t>(level);
    const float weight = level - static_cast<float>(lower);
    const Rgb fine = bilinear(pyramid, pyramid.levels[lower], inside, repeat);
    return weight > 0 ? glm::mix(fine, bilinear(pyramid, pyramid.levels[lower + 1], inside, repeat), weight) : fine;
}

std::uint32_t TextureSet::resolution(std::uint32_t image) const {
    const MipLevel& finest = textures_[image].pyramid.levels.front();
    return std::max(finest.width, finest.height);
}

std::size_t TextureSet::memory_bytes() const {
    std::size_t total = 0;
    for (const Texture& texture : textures_) {
        total += texture.pyramid.memory_bytes();
    }
    return total;
}

}  // namespace gg
