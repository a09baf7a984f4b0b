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

// The largest difference between a fragment's light and that of its surface in another pixel, as the picture shows it.
float step_to(const Fragment& fragment, Rgb light, const TileFragments& other, const TileLight& other_light,
              std::uint32_t pixel) {
    float largest = 0;
    for (std::uint32_t g = other.begin_of(pixel); g < other.pixels[pixel].end; ++g) {
        if (is_same_surface(fragment, other.fragments[g])) {
            largest = std::max(largest, luminance(fragment.albedo * glm::abs(light - other_light[g])));
        }
    }
    return largest;
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

std::vector<JumpingFragment> PixelMap::jumps_in(std::size_t tile, std::span<const TileFragments> tiles,
                                                std::span<const TileLight> light) const {
    const TileFragments& own = tiles[tile];
    std::vector<JumpingFragment> found;
    for (std::uint32_t p = 0; p < own.pixels.size(); ++p) {
        const std::int64_t x = own.tile.x + p % own.tile.width, y = own.tile.y + p / own.tile.width;
        const std::uint32_t begin = own.begin_of(p), end = own.pixels[p].end;
        float seen = kPi * luminance(own.pixels[p].emitted);
        for (std::uint32_t f = begin; f < end; ++f) {
            seen += luminance(own.fragments[f].albedo * light[tile][f]);
        }
        for (std::uint32_t f = begin; f < end; ++f) {
            float step = 0;
            for (const auto& [dx, dy] : {std::array{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
                if (const Pixel* beside = at(x + dx, y + dy)) {
                    step = std::max(step, step_to(own.fragments[f], light[tile][f], tiles[beside->tile],
                                                  light[beside->tile], beside->index));
                }
            }
            if (step > kJump * seen) {
                found.push_back({p, f - begin});
            }
        }
    }
    return found;
}

}  // namespace gg
