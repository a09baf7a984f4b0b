// Light that points share with those around them on their surface: what these agree about is not worked out again.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/vec.h"
#include "film/fragments.h"
#include "radiosity/hierarchy.h"

namespace gg {

// What a point sees of a sender that glows.
struct SeenSender {
    NodeId sender = kNone;
    float visibility = 0;  // 0..1
    float unoccluded = 0;  // irradiance, luminance, W/m2
};

// Irradiance, W/m2.
struct PointLight {
    Rgb all{0.0F};
    // Part of it: from surfaces that do not glow, beyond what tables say of their directions. It casts no shadows that
    // are sharp enough to change within a pixel.
    Rgb soft{0.0F};
    Rgb sky{0.0F};                      // part of it: from the sky's leaves
    std::vector<SeenSender> glowing{};  // whose visibility was looked at, in ascending order
};

// What is known of the light at a point before it is shaded: parts of PointLight.
struct KnownLight {
    std::optional<Rgb> soft = std::nullopt, sky = std::nullopt;
    std::vector<SeenSender> glowing{};
};

struct Sharing {
    // Of pixels that share nothing and are shaded first, a power of two; 1: all of them.
    int spacing = 1;
    float tolerance = 0;  // by how much shared light may differ around a point, of all light there
};

// cell: side of a grid cell, pixels. threshold: as of GatherSettings.
[[nodiscard]] Sharing sharing_in(float cell, float threshold);

// Pixels that are shaded together; neighbours follow one another.
struct SharingStage {
    struct Step {
        int x = 0, y = 0;
    };
    std::vector<std::uint32_t> pixels;  // of the tile
    // Each of them lies in the middle between pixels that are as far before and behind it; none: it shares nothing.
    std::vector<Step> across;
};

// Every pixel of a tile once: first those of a coarse grid, then again and again those between pixels that had their
// turn.
[[nodiscard]] std::vector<SharingStage> sharing_stages(std::uint32_t width, std::uint32_t height, int spacing);

// What a fragment of a pixel of the stage shares with those of its surface in the pixels around it, which have been
// shaded. light: of all fragments of the tile. fragment: of the tile.
[[nodiscard]] KnownLight shared_light(const TileFragments& tile, std::span<const PointLight> light,
                                      const SharingStage& stage, std::uint32_t pixel, std::uint32_t fragment,
                                      float tolerance);

}  // namespace gg
