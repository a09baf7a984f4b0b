#include "gather/pixel_map.h"

#include <algorithm>

namespace gg {

PixelMap::PixelMap(std::span<const TileFragments> tiles) : tiles_(tiles) {
    for (const TileFragments& tile : tiles) {
        width_ = std::max(width_, tile.tile.x + tile.tile.width);
        height_ = std::max(height_, tile.tile.y + tile.tile.height);
    }
    pixels_.resize(std::size_t{width_} * height_);
    for (std::uint32_t t = 0; t < tiles.size(); ++t) {
        const Rectangle& r = tiles[t].tile;
        for (std::uint32_t p = 0; p < r.width * r.height; ++p) {
            pixels_[std::size_t{r.y + p / r.width} * width_ + r.x + p % r.width] = {t, p};
        }
    }
}

const PixelMap::Pixel* PixelMap::beside(std::size_t tile, std::uint32_t index, int dx, int dy) const {
    const Rectangle& r = tiles_[tile].tile;
    const std::int64_t x = std::int64_t{r.x + index % r.width} + dx, y = std::int64_t{r.y + index / r.width} + dy;
    if (x < 0 || y < 0 || x >= width_ || y >= height_) {
        return nullptr;
    }
    return &pixels_[static_cast<std::size_t>(y) * width_ + static_cast<std::size_t>(x)];
}

}  // namespace gg
