#include "film/solution_view.h"

#include <atomic>
#include <vector>

#include "core/control.h"
#include "core/parallel.h"

namespace gg {

ViewCounts render_view(const View& view, const IrradianceAt& irradiance_at, Film& film, Control& control) {
    std::atomic<std::uint64_t> dropped{0};
    std::atomic<std::uint32_t> finished{0};
    parallel_for(film.tile_count(), 1, control, [&](std::size_t index) {
        const TileFragments tile = trace_lit_tile(view, film.tile(static_cast<std::uint32_t>(index)), irradiance_at);
        std::vector<Rgba> pixels(tile.pixels.size());
        dropped += resolve_tile(view, tile, {}, pixels);
        film.finish_tile(static_cast<std::uint32_t>(index), pixels);
        control.set_stage_progress(static_cast<float>(++finished) / static_cast<float>(film.tile_count()));
    });
    const std::uint64_t pixels = std::uint64_t{view.settings.crop.width} * view.settings.crop.height;
    return {pixels * view.settings.samples, dropped};
}

}  // namespace gg
