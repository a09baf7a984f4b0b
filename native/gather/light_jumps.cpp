#include "gather/light_jumps.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gg {

namespace {

constexpr float kJump = 0.2F;         // of the pixel's light
constexpr float kSameSurface = 0.9F;  // cosine between normals

bool is_same_surface(const Fragment& a, const Fragment& b) {
    return a.hit.instance == b.hit.instance && a.back == b.back && dot(a.normal, b.normal) > kSameSurface;
}

}  // namespace

PixelMap::PixelMap(std::span<const TileFragments> tiles) {
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

const PixelMap::Pixel* PixelMap::at(std::int64_t x, std::int64_t y) const {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) {
        return nullptr;
    }
    return &pixels_[static_cast<std::size_t>(y) * width_ + static_cast<std::size_t>(x)];
}

std::vector<std::uint32_t> PixelMap::jumps_in(std::size_t tile, std::span<const TileFragments> tiles,
                                              std::span<const TileLight> light) const {
    const TileFragments& own = tiles[tile];
    std::vector<std::uint32_t> found;
    for (std::uint32_t p = 0; p < own.pixels.size(); ++p) {
        const std::int64_t x = own.tile.x + p % own.tile.width, y = own.tile.y + p / own.tile.width;
        float pixel = luminance(own.pixels[p].emitted) * kPi;
        for (std::uint32_t f = own.begin_of(p); f < own.pixels[p].end; ++f) {
            pixel += luminance(own.fragments[f].albedo * light[tile][f]);
        }
        bool jumps = false;
        for (const auto& [dx, dy] : {std::array{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
            const Pixel* neighbour = at(x + dx, y + dy);
            if (neighbour == nullptr) {
                continue;
            }
            const TileFragments& other = tiles[neighbour->tile];
            for (std::uint32_t f = own.begin_of(p); f < own.pixels[p].end && !jumps; ++f) {
                for (std::uint32_t g = other.begin_of(neighbour->index); g < other.pixels[neighbour->index].end; ++g) {
                    if (is_same_surface(own.fragments[f], other.fragments[g])) {
                        const float step =
                            luminance(own.fragments[f].albedo * glm::abs(light[tile][f] - light[neighbour->tile][g]));
                        jumps = jumps || step > (getenv("GG_J") ? atof(getenv("GG_J")) : kJump) * pixel;
                    }
                }
            }
        }
        if (jumps) {
            found.push_back(p);
        }
    }
    return found;
}

}  // namespace gg
