// What is seen: fragments of surfaces in every pixel. Light is worked out once for each, coverage and texture at every
// sample of the pixel.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/vec.h"
#include "film/view.h"

namespace gg {

// Samples of a pixel that met the same side of one instance, about in one plane.
struct Fragment {
    Hit hit;                    // of the sample next to the middle of the fragment; distance along the view direction
    bool back = false;          // of the triangle, is seen
    Vec3 position{0.0F};        // world
    Vec3 normal{0.0F};          // unit, geometric, of the side that is seen
    Vec3 shading_normal{0.0F};  // unit, of that side
    float share = 0;            // of the pixel's samples
    Rgb albedo{0.0F};           // share times the mean reflectance of its samples
};

struct PixelFragments {
    std::uint32_t end = 0;  // of the pixel's in TileFragments::fragments; they begin where those of the last one end
    std::uint32_t samples = 0;  // coverage samples: more than the settings say where bright things end
    Rgb emitted{0.0F};          // mean over samples of radiance that needs no light: emission, the world
    float alpha = 0;            // 0..1
    float kept = 0;             // share of the samples that are finite; a pixel is the mean of these
};

struct TileFragments {
    Rectangle tile;
    std::vector<PixelFragments> pixels;  // row by row from the lower left
    std::vector<Fragment> fragments;

    // pixel: index into pixels.
    [[nodiscard]] std::uint32_t begin_of(std::size_t pixel) const { return pixel > 0 ? pixels[pixel - 1].end : 0; }
    [[nodiscard]] std::size_t bytes() const {
        return pixels.capacity() * sizeof(PixelFragments) + fragments.capacity() * sizeof(Fragment);
    }
};

// Irradiance [W/m2] where a ray met a surface, at its front or back.
using IrradianceAt = std::function<Rgb(const Hit& hit, bool back)>;

// expected: about how light surfaces are, for more samples where light ones end; null: unknown.
[[nodiscard]] TileFragments trace_tile(const View& view, const Rectangle& tile, const IrradianceAt* expected = nullptr);

// Samples of a fragment that lie next to one another, as a fragment of their own.
struct FragmentPart {
    Fragment at;
    std::uint32_t fragment = 0;  // of the pixel's: which one it is a part of
};

// The parts of a pixel's fragments, in their order, where light changes within them. pixel: index into the tile's
// pixels. halvings: of each, so that it has up to 2^halvings parts.
[[nodiscard]] std::vector<FragmentPart> divide_pixel(const View& view, const TileFragments& tile, std::size_t pixel,
                                                     int halvings);

// The same without fragments: every sample has light of its own, which counts as emitted.
[[nodiscard]] TileFragments trace_lit_tile(const View& view, const Rectangle& tile, const IrradianceAt& irradiance_at);

// irradiance [W/m2]: of every fragment. pixels: of the tile. Returns the number of samples that were left out because
// something about them is not finite.
std::uint64_t resolve_tile(const View& view, const TileFragments& tile, std::span<const Rgb> irradiance,
                           std::span<Rgba> pixels);

}  // namespace gg
