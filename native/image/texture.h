// Image textures: files and pixels become linear-light mip pyramids that any thread reads without a lock.
//
// OpenImageIO reads the files; its texture cache is not used. Measured on untiled 4096 x 4096 JPEG files with automatic
// mip-maps: 2.8 s until the first lookups of a file are done and 550 to 820 ns for a later one, because mip levels are
// made tile by tile under locks, and it would filter sRGB values as if they were linear. The price here: a file is read
// as a whole, as Cycles does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/vec.h"
#include "image/mip_pyramid.h"

namespace gg {

class Control;
class Messages;

// What lies outside of [0, 1]: the image again, its border, black, the image mirrored.
enum class Wrap : std::uint8_t { kRepeat, kExtend, kClip, kMirror };

// A file, or pixels when path is empty.
struct ImageSource {
    std::string name;  // shown in messages
    std::string path;
    std::span<const float> pixels;  // (height, width, 4) RGBA, bottom row first; alpha is ignored
    std::uint32_t width = 0, height = 0;
    bool srgb = true;  // values are sRGB encoded, else linear
    Wrap wrap = Wrap::kRepeat;
    bool closest = false;  // a magnified texel is a square of one colour
};

class TextureSet {
  public:
    TextureSet() = default;
    // Reads all images; keeps nothing of `sources`. One that cannot be read becomes a message and is magenta,
    // (1, 0, 1), as in Cycles. While all together exceed `memory_limit` bytes, the largest loses its finest level, with
    // a message: this degrades evenly, where a cache that is too small would read files again and again.
    TextureSet(std::span<const ImageSource> sources, const Control& control, Messages& messages,
               std::size_t memory_limit = kDefaultMemoryLimit);

    [[nodiscard]] std::size_t size() const { return textures_.size(); }
    // Linear colour of image (< size()) at uv, (0, 0) the lower left corner, averaged over about a square of side
    // `width` in uv; 0: the finest level. Finite; negative only where the source is. Black where uv is not finite.
    [[nodiscard]] Rgb lookup(std::uint32_t image, Vec2 uv, float width) const;
    // Texels along the longer side of image's finest level.
    [[nodiscard]] std::uint32_t resolution(std::uint32_t image) const;
    [[nodiscard]] std::size_t memory_bytes() const;

    static constexpr std::size_t kDefaultMemoryLimit = std::size_t{4} << 30;

  private:
    struct Texture {
        MipPyramid pyramid;
        Wrap wrap = Wrap::kRepeat;
        bool closest = false;
    };
    std::vector<Texture> textures_;
};

}  // namespace gg
