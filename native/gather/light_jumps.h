// Pixels in which light may change: every sample of theirs needs light of its own.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "film/fragments.h"

namespace gg {

using TileLight = std::vector<Rgb>;  // irradiance of a tile's fragments, W/m2

// Where the picture's pixels lie.
class PixelMap {
  public:
    explicit PixelMap(std::span<const TileFragments> tiles);

    // Of tile `tile`, in ascending order: pixels with a fragment whose light differs from that of a neighbour's on the
    // same surface, so much that it is seen.
    [[nodiscard]] std::vector<std::uint32_t> jumps_in(std::size_t tile, std::span<const TileFragments> tiles,
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
