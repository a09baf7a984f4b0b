#include "film/radiosity_view.h"

#include "core/parallel.h"

namespace gg {

std::vector<Rgb> radiosity_view(const View& view, std::span<const TileFragments> tiles,
                                const FragmentIrradiance& irradiance_of, const Control& control) {
    const std::size_t width = view.settings.crop.width;
    std::vector<Rgb> picture(width * view.settings.crop.height);
    parallel_for(tiles.size(), 1, control, [&](std::size_t t) {
        const TileFragments& tile = tiles[t];
        std::vector<Rgb> irradiance;
        irradiance.reserve(tile.fragments.size());
        for (const Fragment& at : tile.fragments) {
            irradiance.push_back(irradiance_of(at));
        }
        std::vector<Rgba> pixels(tile.pixels.size());
        resolve_tile(view, tile, irradiance, pixels);
        for (std::size_t p = 0; p < pixels.size(); ++p) {
            picture[(tile.tile.y + p / tile.tile.width) * width + tile.tile.x + p % tile.tile.width] = pixels[p].color;
        }
    });
    return picture;
}

}  // namespace gg
