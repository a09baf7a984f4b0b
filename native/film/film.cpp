#include "film/film.h"

#include <algorithm>

namespace gg {

Film::Film(std::uint32_t width, std::uint32_t height)
    : width_(width),
      height_(height),
      tiles_x_((width + kTileSize - 1) / kTileSize),
      tiles_y_((height + kTileSize - 1) / kTileSize),
      pixels_(std::size_t{width} * height) {}

Rectangle Film::tile(std::uint32_t index) const {
    const std::uint32_t x = index % tiles_x_ * kTileSize;
    const std::uint32_t y = index / tiles_x_ * kTileSize;
    return {x, y, std::min(kTileSize, width_ - x), std::min(kTileSize, height_ - y)};
}

void Film::finish_tile(std::uint32_t index, std::span<const Rgba> pixels) {
    const Rectangle area = tile(index);
    const std::lock_guard lock(mutex_);
    for (std::uint32_t row = 0; row < area.height; ++row) {
        std::copy_n(pixels.begin() + row * area.width, area.width,
                    pixels_.begin() + std::size_t{area.y + row} * width_ + area.x);
    }
    finished_.push_back(index);
}

std::uint32_t Film::finished_tiles() const {
    const std::lock_guard lock(mutex_);
    return static_cast<std::uint32_t>(finished_.size());
}

std::optional<Rectangle> Film::next_finished_tile() {
    const std::lock_guard lock(mutex_);
    if (next_ == finished_.size()) {
        return std::nullopt;
    }
    return tile(finished_[next_++]);
}

void Film::read(const Rectangle& area, std::span<Rgba> pixels) const {
    const std::lock_guard lock(mutex_);
    for (std::uint32_t row = 0; row < area.height; ++row) {
        std::copy_n(pixels_.begin() + std::size_t{area.y + row} * width_ + area.x, area.width,
                    pixels.begin() + std::size_t{row} * area.width);
    }
}

bool Film::contains(const Rectangle& area) const {
    return area.width >= 1 && area.height >= 1 && area.x < width_ && area.y < height_ &&
           area.width <= width_ - area.x && area.height <= height_ - area.y;
}

}  // namespace gg
