// The picture while it grows: tiles are written by the working threads and read by the caller.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "core/vec.h"
#include "film/passes.h"

namespace gg {

struct Rgba {
    Rgb color{0.0F};  // premultiplied, scene-linear
    float alpha = 0;
};

// Pixels from the lower left.
struct Rectangle {
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
};

// Thread-safe but for construction.
class Film {
  public:
    static constexpr std::uint32_t kTileSize = 32;

    // width, height >= 1. passes: kept besides the picture.
    Film(std::uint32_t width, std::uint32_t height, PassSet passes = {});

    [[nodiscard]] std::uint32_t tile_count() const { return tiles_x_ * tiles_y_; }
    [[nodiscard]] Rectangle tile(std::uint32_t index) const;  // row by row from the lower left
    // `pixels` has the tile's size, bottom row first, and so have `values` if there are any. Once per tile.
    void finish_tile(std::uint32_t index, std::span<const Rgba> pixels, std::span<const PassValues> values = {});

    [[nodiscard]] std::uint32_t finished_tiles() const;
    // The next finished tile that was not asked for, in order of finishing.
    [[nodiscard]] std::optional<Rectangle> next_finished_tile();
    // Rows of `area`, which lies within the picture, bottom row first; 0 where tiles are not finished.
    void read(const Rectangle& area, std::span<Rgba> pixels) const;
    // The same of a pass; false, and nothing is read, if it is not kept.
    bool read(const Rectangle& area, Pass pass, std::span<float> values) const;
    [[nodiscard]] PassSet passes() const { return passes_; }
    [[nodiscard]] bool contains(const Rectangle& area) const;
    [[nodiscard]] std::size_t bytes() const;

  private:
    std::uint32_t width_, height_, tiles_x_, tiles_y_;
    PassSet passes_;
    mutable std::mutex mutex_;
    std::vector<Rgba> pixels_;
    std::array<std::vector<float>, kPassCount> values_;  // empty where not kept
    std::vector<std::uint32_t> finished_;                // in order of finishing
    std::size_t next_ = 0;                               // into finished_
};

}  // namespace gg
