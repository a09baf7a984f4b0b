// Where the picture's pixels lie among its tiles.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "film/fragments.h"

namespace gg {

class PixelMap {
  public:
    // The tiles must outlive this.
    explicit PixelMap(std::span<const TileFragments> tiles);

    struct Pixel {
        std::uint32_t tile = kNone, index = 0;  // of the tile's pixels
    };
    // The pixel so many steps from a pixel of a tile, or null outside of the picture.
    [[nodiscard]] const Pixel* beside(std::size_t tile, std::uint32_t index, int dx, int dy) const;
    [[nodiscard]] std::span<const TileFragments> tiles() const { return tiles_; }

  private:
    std::span<const TileFragments> tiles_;
    std::uint32_t width_ = 0, height_ = 0;
    std::vector<Pixel> pixels_;
};

}  // namespace gg
