#include "film/film.h"

#include <algorithm>

namespace gg {

Film::Film(std::uint32_t width, std::uint32_t height, PassSet passes)
    : width_(width),
      height_(height),
      tiles_x_((width + kTileSize - 1) / kTileSize),
      tiles_y_((height + kTileSize - 1) / kTileSize),
      passes_(passes),
      pixels_(std::size_t{width} * height) {
    for (std::uint32_t pass = 0; pass < kPassCount; ++pass) {
        if (passes.has(static_cast<Pass>(pass))) {
            values_[pass].resize(pixels_.size());
        }
    }
}

Rectangle Film::tile(std::uint32_t index) const {
    const std::uint32_t x = index % tiles_x_ * kTileSize;
    const std::uint32_t y = index / tiles_x_ * kTileSize;
    return {x, y, std::min(kTileSize, width_ - x), std::min(kTileSize, height_ - y)};
}

void Film::finish_tile(std::uint32_t index, std::span<const Rgba> pixels, std::span<const PassValues> values) {
    const Rectangle area = tile(index);
    const std::lock_guard lock(mutex_);
    for (std::uint32_t row = 0; row < area.height; ++row) {
        std::copy_n(pixels.begin() + row * area.width, area.width,
                    pixels_.begin() + std::size_t{area.y + row} * width_ + area.x);
    }
    for (std::uint32_t pass = 0; pass < kPassCount; ++pass) {
        for (std::size_t i = 0; i < values.size() && !values_[pass].empty(); ++i) {
            values_[pass][(area.y + i / area.width) * width_ + area.x + i % area.width] = values[i].of[pass];
        }
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

bool Film::read(const Rectangle& area, Pass pass, std::span<float> values) const {
    const std::vector<float>& source = values_[static_cast<std::size_t>(pass)];
    if (source.empty()) {
        return false;
    }
    const std::lock_guard lock(mutex_);
    for (std::uint32_t row = 0; row < area.height; ++row) {
        std::copy_n(source.begin() + static_cast<std::ptrdiff_t>(std::size_t{area.y + row} * width_ + area.x),
                    area.width, values.begin() + std::size_t{row} * area.width);
    }
    return true;
}

std::size_t Film::bytes() const {
    std::size_t bytes = pixels_.size() * sizeof(Rgba);
    for (const std::vector<float>& values : values_) {
        bytes += values.size() * sizeof(float);
    }
    return bytes;
}

bool Film::contains(const Rectangle& area) const {
    return area.width >= 1 && area.height >= 1 && area.x < width_ && area.y < height_ &&
           area.width <= width_ - area.x && area.height <= height_ - area.y;
}

}  // namespace gg
