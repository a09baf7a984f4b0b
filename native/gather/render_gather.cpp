#include "gather/render_gather.h"

#include <array>
#include <atomic>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

#include "core/control.h"
#include "core/parallel.h"
#include "core/statistics.h"
#include "gather/classify.h"
#include "gather/full_gather.h"
#include "gather/grid_sites.h"
#include "gather/shade.h"

namespace gg {

namespace {

constexpr int kFullSamples = 256;
constexpr float kDarkest = 0.1F;       // share of the mean radiosity below which places tolerate no less
constexpr float kCellsAcross = 17.5F;  // along the short side of a picture
constexpr std::size_t kSitesAtOnce = 64;

// What the radiosity solution says of a fragment, luminance [W/m2].
float expected_irradiance(const Solution& solution, const Fragment& at) {
    return luminance(
        interpolated_irradiance(solution, at.hit.instance, at.hit.triangle, at.back, {at.hit.u, at.hit.v}));
}

// Fills the film, tile by tile: what light_of(tile) gives for the fragments of tile_at(index).
ViewCounts fill_tiles(const View& view, Film& film, Control& control,
                      const std::function<TileFragments(std::uint32_t)>& tile_at,
                      const std::function<std::vector<Rgb>(const TileFragments&)>& light_of) {
    std::atomic<std::uint64_t> dropped{0};
    std::atomic<std::uint32_t> finished{0};
    parallel_for(film.tile_count(), 1, control, [&](std::size_t i) {
        const auto index = static_cast<std::uint32_t>(i);
        const TileFragments tile = tile_at(index);
        const std::vector<Rgb> irradiance = light_of(tile);
        std::vector<Rgba> pixels(tile.pixels.size());
        dropped += resolve_tile(view, tile, irradiance, pixels);
        film.finish_tile(index, pixels);
        control.set_stage_progress(static_cast<float>(++finished) / static_cast<float>(film.tile_count()));
    });
    const std::uint64_t pixels = std::uint64_t{view.settings.crop.width} * view.settings.crop.height;
    return {pixels * view.settings.samples, dropped};
}

}  // namespace

ViewCounts full_gather(const Solution& solution, const View& view, Film& film, Control& control,
                       Statistics& statistics) {
    const ClusterPoints points(solution, control);
    std::mutex mutex;
    GatherCounts total;
    const auto light_of = [&](const TileFragments& tile) {
        FullGather gather(solution, points, view.tracer, kFullSamples);
        std::vector<Rgb> irradiance;
        irradiance.reserve(tile.fragments.size());
        for (const Fragment& fragment : tile.fragments) {
            control.check_cancel();
            irradiance.push_back(gather.irradiance(fragment, expected_irradiance(solution, fragment)));
        }
        const std::scoped_lock lock(mutex);
        total += gather.counts();
        return irradiance;
    };
    const ViewCounts counts = fill_tiles(
        view, film, control, [&](std::uint32_t index) { return trace_tile(view, film.tile(index)); }, light_of);
    statistics.set_count("gathered points", static_cast<double>(total.points));
    statistics.set_count("resampled senders", static_cast<double>(total.senders));
    statistics.set_count("visibility rays", static_cast<double>(total.visibility_rays));
    statistics.set_count("near rays", static_cast<double>(total.near_rays));
    return counts;
}

ViewCounts grid_gather(const Solution& solution, const View& view, std::uint32_t width, std::uint32_t height,
                       Film& film, Control& control, Statistics& statistics) {
    std::vector<TileFragments> tiles(film.tile_count());
    {
        const StageTimer timer(statistics, "visible points");
        parallel_for(tiles.size(), 1, control,
                     [&](std::size_t i) { tiles[i] = trace_tile(view, film.tile(static_cast<std::uint32_t>(i))); });
    }
    std::vector<Site> sites;
    const ClusterPoints points(solution, control);
    const NodeOrder order(hierarchy_of(solution));
    GridSettings cells;
    cells.cell = static_cast<float>(std::min(width, height)) / kCellsAcross;
    const PerspectiveGrid grid = fit_grid(view, static_cast<float>(width), static_cast<float>(height), tiles, cells);
    const GridReceivers receivers(solution, grid, tiles, control);
    {
        const StageTimer timer(statistics, "classification");
        ClassifySettings settings;
        settings.least_radiosity = kDarkest * receivers.mean_radiosity();
        sites.resize(receivers.site_count());
        std::mutex mutex;
        GatherCounts total;
        parallel_blocks(sites.size(), kSitesAtOnce, control, [&](std::size_t begin, std::size_t end) {
            Classifier classifier(solution, order, points, view.tracer, settings);
            for (std::size_t i = begin; i < end; ++i) {
                sites[i] = classifier.classify(receivers.of(i));
            }
            const std::scoped_lock lock(mutex);
            total += classifier.counts();
        });
        statistics.set_count("sites", static_cast<double>(total.points));
        statistics.set_count("grid vertices", static_cast<double>(grid.vertex_count()));
        statistics.set_count("senders of sites", static_cast<double>(total.senders));
        statistics.set_count("rays of classification", static_cast<double>(total.visibility_rays + total.near_rays));
        statistics.set_count("senders resampled: both", static_cast<double>(total.both));
        statistics.set_count("senders resampled: visibility", static_cast<double>(total.only_visibility));
        statistics.set_count("senders resampled: form factor", static_cast<double>(total.only_form_factor));
    }
    const StageTimer timer(statistics, "shading");
    std::mutex mutex;
    GatherCounts total;
    const auto light_of = [&](const TileFragments& tile) {
        Shader shader(solution, order, points, view.tracer);
        std::vector<Rgb> irradiance;
        irradiance.reserve(tile.fragments.size());
        for (const Fragment& fragment : tile.fragments) {
            control.check_cancel();
            const GridPlace place = grid.place(fragment.position);
            std::array<WeightedSite, 4> around;
            std::size_t count = 0;
            for (int k = 0; k < 4; ++k) {
                if (place.weights[k] > 0) {
                    around[count++] = {&sites[receivers.site_at(place.vertices[k])], place.weights[k]};
                }
            }
            irradiance.push_back(shader.irradiance(fragment, std::span(around).first(count)));
        }
        const std::scoped_lock lock(mutex);
        total += shader.counts();
        return irradiance;
    };
    const ViewCounts counts = fill_tiles(
        view, film, control, [&](std::uint32_t index) { return std::move(tiles[index]); }, light_of);
    statistics.set_count("gathered points", static_cast<double>(total.points));
    statistics.set_count("resampled senders", static_cast<double>(total.senders));
    statistics.set_count("near rays", static_cast<double>(total.near_rays));
    statistics.set_count("form factors", static_cast<double>(total.form_factors));
    statistics.set_count("visibility rays", static_cast<double>(total.visibility_rays));
    return counts;
}

}  // namespace gg
