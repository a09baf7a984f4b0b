// Fragments within which light may change: parts of theirs need light of their own.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gather/pixel_map.h"

namespace gg {

using TileLight = std::vector<Rgb>;  // irradiance of a tile's fragments, W/m2

struct JumpingFragment {
    std::uint32_t pixel = 0;     // of the tile
    std::uint32_t fragment = 0;  // of the pixel
    float step = 0;              // as the picture would show it, over the light of the pixel
};

// Of tile `tile`, in ascending order: fragments whose light differs from that of the same surface in a pixel beside
// theirs, so much that it is seen. light: of all tiles.
[[nodiscard]] std::vector<JumpingFragment> jumps_in(const PixelMap& map, std::size_t tile,
                                                    std::span<const TileLight> light);

}  // namespace gg
