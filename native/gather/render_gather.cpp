#include "gather/render_gather.h"

#include <array>
#include <atomic>
#include <mutex>
#include <span>
#include <vector>

#include "core/control.h"
#include "core/parallel.h"
#include "core/statistics.h"
#include "gather/classify.h"
#include "gather/full_gather.h"
#include "gather/grid_sites.h"
#include "gather/light_jumps.h"
#include "gather/shade.h"

namespace gg {

namespace {

constexpr int kFullSamples = 256;
constexpr float kCellsAcross = 17.5F;  // along the short side of a picture
constexpr std::size_t kSitesAtOnce = 64;
constexpr std::size_t kFragmentsAtOnce = 32;  // neighbours, whose rays go together
constexpr int kHalvings = 2;                  // of fragments in which light jumps
constexpr float kQuartersJump = 0.5F;         // of the pixel's light, between parts that are divided further

// What the radiosity solution says of a fragment, luminance [W/m2].
float expected_irradiance(const Solution& solution, const Fragment& at) {
    return luminance(
        interpolated_irradiance(solution, at.hit.instance, at.hit.triangle, at.back, {at.hit.u, at.hit.v}));
}

std::vector<TileFragments> trace_tiles(const View& view, const Film& film, Control& control, Statistics& statistics) {
    const StageTimer timer(statistics, "visible points");
    std::vector<TileFragments> tiles(film.tile_count());
    parallel_for(tiles.size(), 1, control,
                 [&](std::size_t i) { tiles[i] = trace_tile(view, film.tile(static_cast<std::uint32_t>(i))); });
    return tiles;
}

void report(const GatherCounts& total, Statistics& statistics) {
    statistics.set_count("gathered points", static_cast<double>(total.points));
    statistics.set_count("resampled senders", static_cast<double>(total.senders));
    statistics.set_count("form factors", static_cast<double>(total.form_factors));
    statistics.set_count("visibility rays", static_cast<double>(total.visibility_rays));
    statistics.set_count("near rays", static_cast<double>(total.near_rays));
}

// Works out the mean light over the parts of a fragment. Returns how much it differs between them, as the picture would
// show it if each were the whole fragment.
template <typename Gatherer>
float light_of_parts(std::span<const FragmentPart> parts, std::uint32_t fragment, Gatherer& gatherer, Rgb& mean) {
    std::vector<Fragment> own;
    for (const FragmentPart& part : parts) {
        if (part.fragment == fragment) {
            own.push_back(part.at);
        }
    }
    TileLight light(own.size());
    gatherer.shade(own, light);
    Rgb reflected(0.0F), albedo(0.0F), least(kInfinity), most(0.0F);
    for (std::size_t i = 0; i < own.size(); ++i) {
        reflected += own[i].albedo * light[i];
        albedo += own[i].albedo;
        least = glm::min(least, light[i]);
        most = glm::max(most, light[i]);
    }
    mean = reflected / glm::max(albedo, Rgb(1e-20F));
    return luminance(albedo * (most - least));
}

// The light of a fragment as the mean over its parts, for all of `jumps` that are of its pixel; where its quarters
// differ much, over parts of these.
template <typename Gatherer>
void light_parts(const View& view, const TileFragments& tile, std::span<const JumpingFragment> jumps,
                 Gatherer& gatherer, TileLight& light) {
    const std::size_t pixel = jumps.front().pixel;
    float seen = kPi * luminance(tile.pixels[pixel].emitted);
    for (std::uint32_t f = tile.begin_of(pixel); f < tile.pixels[pixel].end; ++f) {
        seen += luminance(tile.fragments[f].albedo * light[f]);
    }
    const std::vector<FragmentPart> quarters = divide_pixel(view, tile, pixel, kHalvings);
    std::vector<FragmentPart> smaller;
    for (const JumpingFragment& jump : jumps) {
        Rgb& mean = light[tile.begin_of(pixel) + jump.fragment];
        const float step = light_of_parts(quarters, jump.fragment, gatherer, mean);
        if (step > kQuartersJump * seen) {
            if (smaller.empty()) {
                smaller = divide_pixel(view, tile, pixel, 2 * kHalvings);
            }
            light_of_parts(smaller, jump.fragment, gatherer, mean);
        }
    }
}

// Fills the film: gatherers from make(), one for each thread at a time, say what light falls on fragments.
template <typename Make>
ViewCounts shade_tiles(const View& view, std::span<const TileFragments> tiles, const Make& make, Film& film,
                       Control& control, Statistics& statistics) {
    const StageTimer timer(statistics, "shading");
    std::mutex mutex;
    GatherCounts total;
    std::atomic<std::uint32_t> finished{0};
    const auto step = [&](auto& gatherer) {
        const std::scoped_lock lock(mutex);
        total += gatherer.counts();
        control.set_stage_progress(static_cast<float>(++finished) / static_cast<float>(2 * tiles.size()));
    };
    std::vector<TileLight> light(tiles.size());
    parallel_for(tiles.size(), 1, control, [&](std::size_t i) {
        auto gatherer = make();
        light[i].resize(tiles[i].fragments.size());
        for (std::size_t begin = 0; begin < light[i].size(); begin += kFragmentsAtOnce) {
            control.check_cancel();
            const std::size_t count = std::min(kFragmentsAtOnce, light[i].size() - begin);
            gatherer.shade(std::span(tiles[i].fragments).subspan(begin, count),
                           std::span(light[i]).subspan(begin, count));
        }
        step(gatherer);
    });
    std::atomic<std::uint64_t> dropped{0}, divided{0};
    const PixelMap map(tiles);
    parallel_for(tiles.size(), 1, control, [&](std::size_t i) {
        auto gatherer = make();
        TileLight own = light[i];
        const std::vector<JumpingFragment> jumps = map.jumps_in(i, tiles, light);
        for (std::size_t begin = 0, end = 0; begin < jumps.size(); begin = end) {
            control.check_cancel();
            while (end < jumps.size() && jumps[end].pixel == jumps[begin].pixel) {
                ++end;
            }
            light_parts(view, tiles[i], std::span(jumps).subspan(begin, end - begin), gatherer, own);
        }
        divided += jumps.size();
        std::vector<Rgba> pixels(tiles[i].pixels.size());
        dropped += resolve_tile(view, tiles[i], own, pixels);
        film.finish_tile(static_cast<std::uint32_t>(i), pixels);
        step(gatherer);
    });
    report(total, statistics);
    statistics.set_count("fragments divided", static_cast<double>(divided));
    const std::uint64_t pixels = std::uint64_t{view.settings.crop.width} * view.settings.crop.height;
    return {pixels * view.settings.samples, dropped};
}

struct FullGatherer {
    const Solution& solution;
    FullGather gather;

    void shade(std::span<const Fragment> fragments, std::span<Rgb> light) {
        for (std::size_t i = 0; i < fragments.size(); ++i) {
            light[i] = gather.irradiance(fragments[i], expected_irradiance(solution, fragments[i]));
        }
    }
    [[nodiscard]] const GatherCounts& counts() const { return gather.counts(); }
};

struct GridGatherer {
    const PerspectiveGrid& grid;
    const GridReceivers& receivers;
    const std::vector<Site>& sites;
    Shader shader;

    std::vector<PlacedFragment> placed;

    void shade(std::span<const Fragment> fragments, std::span<Rgb> light) {
        placed.clear();
        for (const Fragment& at : fragments) {
            placed.push_back({at, {}, 0});
            PlacedFragment& here = placed.back();
            const GridPlace place = grid.place(at.position);
            float sum = 0;
            for (int k = 0; k < 4; ++k) {
                const std::uint32_t site = receivers.site_at(place.vertices[k]);
                if (place.weights[k] > 0 && site != kNone) {
                    here.around[here.count++] = {&sites[site], place.weights[k]};
                    sum += place.weights[k];
                }
            }
            for (std::uint32_t k = 0; k < here.count; ++k) {
                here.around[k].weight /= sum;
            }
        }
        shader.shade(placed, light);
    }
    [[nodiscard]] const GatherCounts& counts() const { return shader.counts(); }
};

}  // namespace

ViewCounts full_gather(const Solution& solution, const View& view, Film& film, Control& control,
                       Statistics& statistics) {
    const std::vector<TileFragments> tiles = trace_tiles(view, film, control, statistics);
    const ClusterPoints points(solution, control);
    const NodeOrder order(hierarchy_of(solution));
    const auto make = [&] { return FullGatherer{solution, {solution, order, points, view.tracer, kFullSamples}}; };
    return shade_tiles(view, tiles, make, film, control, statistics);
}

ViewCounts grid_gather(const Solution& solution, const View& view, std::uint32_t width, std::uint32_t height,
                       Film& film, Control& control, Statistics& statistics) {
    const std::vector<TileFragments> tiles = trace_tiles(view, film, control, statistics);
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
        settings.mean_radiosity = receivers.mean_radiosity();
        sites.resize(receivers.site_count());
        std::mutex mutex;
        GatherCounts total;
        parallel_blocks(sites.size(), kSitesAtOnce, control, [&](std::size_t begin, std::size_t end) {
            Classifier classifier(solution, order, points, view.tracer, settings);
            for (std::size_t i = begin; i < end; ++i) {
                control.check_cancel();
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
    const auto make = [&] { return GridGatherer{grid, receivers, sites, {solution, order, points, view.tracer}, {}}; };
    return shade_tiles(view, tiles, make, film, control, statistics);
}

}  // namespace gg
