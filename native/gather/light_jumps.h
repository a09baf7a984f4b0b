// Fragments within which light may change: parts of theirs need light of their own.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "film/fragments.h"

namespace gg {

using TileLight = std::vector<Rgb>;  // irradiance of a tile's fragments, W/m2

struct JumpingFragment {
    std::uint32_t pixel = 0;     // of the tile
    std::uint32_t fragment = 0;  // of the pixel
};

// Where the picture's pixels lie.
class PixelMap {
  public:
    explicit PixelMap(std::span<const TileFragments> tiles);

    // Of tile `tile`, in ascending order: fragments whose light differs from that of the same surface in a pixel beside
    // theirs, so much that it is seen.
    [[nodiscard]] std::vector<JumpingFragment> jumps_in(std::size_t tile, std::span<const TileFragments> tiles,
                                                        std::span<const TileLight> light) const;

  private:
    struct Pixel {
        std::uint32_t tile = kNone, index = 0;
    };
    [[nodiscard]] const Pixel* at(std::int64_t x, std::int64_t y) const;

    std::uint32_t width_ = 0, height_ = 0;
    std::vector<Pixel> pixels_;
};

}  // namespace gg
