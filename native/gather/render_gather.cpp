#include "gather/render_gather.h"

#include <atomic>
#include <mutex>
#include <vector>

#include "core/control.h"
#include "core/parallel.h"
#include "core/statistics.h"
#include "gather/full_gather.h"

namespace gg {

namespace {

constexpr int kFullSamples = 256;

// What the radiosity solution says of a fragment, luminance [W/m2].
float expected_irradiance(const Solution& solution, const Fragment& at) {
    return luminance(
        interpolated_irradiance(solution, at.hit.instance, at.hit.triangle, at.back, {at.hit.u, at.hit.v}));
}

}  // namespace

ViewCounts full_gather(const Solution& solution, const View& view, Film& film, Control& control,
                       Statistics& statistics) {
    const ClusterPoints points(solution, control);
    std::atomic<std::uint64_t> dropped{0};
    std::atomic<std::uint32_t> finished{0};
    std::mutex mutex;
    GatherCounts total;
    parallel_for(film.tile_count(), 1, control, [&](std::size_t index) {
        const TileFragments tile = trace_tile(view, film.tile(static_cast<std::uint32_t>(index)));
        FullGather gather(solution, points, view.tracer, kFullSamples);
        std::vector<Rgb> irradiance;
        irradiance.reserve(tile.fragments.size());
        for (const Fragment& fragment : tile.fragments) {
            control.check_cancel();
            irradiance.push_back(gather.irradiance(fragment, expected_irradiance(solution, fragment)));
        }
        std::vector<Rgba> pixels(tile.pixels.size());
        dropped += resolve_tile(view, tile, irradiance, pixels);
        film.finish_tile(static_cast<std::uint32_t>(index), pixels);
        control.set_stage_progress(static_cast<float>(++finished) / static_cast<float>(film.tile_count()));
        const std::scoped_lock lock(mutex);
        total += gather.counts();
    });
    statistics.set_count("gathered points", static_cast<double>(total.points));
    statistics.set_count("resampled senders", static_cast<double>(total.senders));
    statistics.set_count("visibility rays", static_cast<double>(total.visibility_rays));
    statistics.set_count("near rays", static_cast<double>(total.near_rays));
    const std::uint64_t pixels = std::uint64_t{view.settings.crop.width} * view.settings.crop.height;
    return {pixels * view.settings.samples, dropped};
}

}  // namespace gg
