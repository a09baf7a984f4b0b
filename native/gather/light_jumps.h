// Fragments within which light may change: parts of theirs need light of their own.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "film/camera.h"
#include "gather/pixel_map.h"
#include "scene/scene.h"

namespace gg {

using TileLight = std::vector<Rgb>;  // irradiance of a tile's fragments, W/m2

struct JumpingFragment {
    std::uint32_t pixel = 0;     // of the tile
    std::uint32_t fragment = 0;  // of the pixel
    float step = 0;              // as the picture would show it, over the light of the pixel
    bool at_lamp = false;        // what lies behind a lamp may be a thin strip, which large parts miss
};

// Of tile `tile`, in ascending order: fragments whose light differs from that of the same surface in a pixel beside
// theirs, so much that it is seen, and those across which a flat lamp begins. light: of all tiles.
[[nodiscard]] std::vector<JumpingFragment> jumps_in(const PixelMap& map, std::size_t tile,
                                                    std::span<const TileLight> light, std::span<const Lamp> lamps,
                                                    const PixelCamera& camera);

// How far a pixel reaches over the surface that it shows, m.
[[nodiscard]] float pixel_reach(const Fragment& fragment, const PixelCamera& camera);

// Where a flat lamp's edge touches the surface within reach [m] of the fragment: irradiance before the lamp, W/m2. What
// lies behind it has none. 0 elsewhere.
[[nodiscard]] Rgb step_at(const Lamp& lamp, const Fragment& fragment, float reach);

}  // namespace gg
