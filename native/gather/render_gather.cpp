#include "gather/render_gather.h"

#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "core/control.h"
#include "core/parallel.h"
#include "core/random.h"
#include "core/statistics.h"
#include "gather/classify.h"
#include "gather/free_space.h"
#include "gather/full_gather.h"
#include "gather/grid_sites.h"
#include "gather/light_tiles.h"
#include "gather/shade.h"

namespace gg {

namespace {

constexpr float kStandardHeight = 350;  // pixels, of pictures that settings are meant for
constexpr std::size_t kSitesAtOnce = 64;
constexpr std::uint64_t kFreeSpaceSeed = 0x66726565;

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

class FullGatherer : public Gatherer {
  public:
    FullGatherer(const Solution& solution, const NodeOrder& order, const ClusterPoints& points, const RayTracer& tracer,
                 int samples)
        : solution_(solution), gather_(solution, order, points, tracer, samples) {}

    void shade(std::span<const Fragment> fragments, std::span<Rgb> light, std::span<PointCounts> taken) override {
        for (std::size_t i = 0; i < fragments.size(); ++i) {
            const GatherCounts before = gather_.counts();
            light[i] = gather_.irradiance(fragments[i], expected_irradiance(solution_, fragments[i]));
            const GatherCounts& now = gather_.counts();
            taken[i] = {static_cast<std::uint32_t>(now.visibility_rays + now.near_rays - before.visibility_rays -
                                                   before.near_rays),
                        static_cast<std::uint32_t>(now.form_factors - before.form_factors),
                        static_cast<std::uint32_t>(now.senders - before.senders)};
        }
    }
    [[nodiscard]] const GatherCounts& counts() const override { return gather_.counts(); }
    [[nodiscard]] std::uint32_t cell_of(const Fragment&) const override { return 0; }

  private:
    const Solution& solution_;
    FullGather gather_;
};

// Points in the cells around a site's vertex.
FreeSpace free_space_around(const PerspectiveGrid& grid, const GridReceivers& receivers, std::size_t site) {
    const std::uint32_t vertex = receivers.vertex_of(site);
    const Sequence4 places(hash64(vertex, kFreeSpaceSeed));
    FreeSpace space{grid.near_vertex(vertex, Vec3(0.0F)), {}, receivers.of(site)};
    for (std::uint32_t i = 0; i < FreeSpaceClassifier::kMostPoints; ++i) {
        space.points.push_back(
            grid.near_vertex(vertex, 2.0F * Vec3(places(i, 0), places(i, 1), places(i, 2)) - Vec3(1.0F)));
    }
    return space;
}

// All sites, by classifiers that make() gives, one for a block of them.
template <typename Make, typename Classify>
GatherCounts make_sites(const Make& make, const Classify& classify, std::vector<Site>& sites, const Control& control) {
    std::mutex mutex;
    GatherCounts total;
    parallel_blocks(sites.size(), kSitesAtOnce, control, [&](std::size_t begin, std::size_t end) {
        auto classifier = make();
        for (std::size_t i = begin; i < end; ++i) {
            control.check_cancel();
            sites[i] = classify(classifier, i);
        }
        const std::scoped_lock lock(mutex);
        total += classifier.counts();
    });
    return total;
}

void report_sites(const GatherCounts& total, const PerspectiveGrid& grid, Statistics& statistics) {
    statistics.set_count("sites", static_cast<double>(total.points));
    statistics.set_count("grid vertices", static_cast<double>(grid.vertex_count()));
    statistics.set_count("senders of sites", static_cast<double>(total.senders));
    statistics.set_count("rays of classification", static_cast<double>(total.visibility_rays + total.near_rays));
    statistics.set_count("senders resampled: both", static_cast<double>(total.both));
    statistics.set_count("senders resampled: visibility", static_cast<double>(total.only_visibility));
    statistics.set_count("senders resampled: form factor", static_cast<double>(total.only_form_factor));
}

class GridGatherer : public Gatherer {
  public:
    GridGatherer(const PerspectiveGrid& grid, const GridReceivers& receivers, std::span<const Site> sites,
                 const Shader& shader)
        : grid_(grid), receivers_(receivers), sites_(sites), shader_(shader) {}

    void shade(std::span<const Fragment> fragments, std::span<Rgb> light, std::span<PointCounts> taken) override {
        placed_.clear();
        for (const Fragment& at : fragments) {
            placed_.push_back({at, {}, 0});
            PlacedFragment& here = placed_.back();
            const GridPlace place = grid_.place(at.position);
            float sum = 0;
            for (int k = 0; k < 4; ++k) {
                const std::uint32_t site = receivers_.site_at(place.vertices[k]);
                if (place.weights[k] > 0 && site != kNone) {
                    here.around[here.count++] = {&sites_[site], place.weights[k]};
                    sum += place.weights[k];
                }
            }
            for (std::uint32_t k = 0; k < here.count; ++k) {
                here.around[k].weight /= sum;
            }
        }
        shader_.shade(placed_, light, taken);
    }
    [[nodiscard]] const GatherCounts& counts() const override { return shader_.counts(); }
    [[nodiscard]] std::uint32_t cell_of(const Fragment& fragment) const override {
        return grid_.cell_at(fragment.position);
    }

  private:
    const PerspectiveGrid& grid_;
    const GridReceivers& receivers_;
    std::span<const Site> sites_;
    Shader shader_;
    std::vector<PlacedFragment> placed_;
};

}  // namespace

ViewCounts full_gather(const Solution& solution, const View& view, int samples, Film& film, Control& control,
                       Statistics& statistics) {
    const std::vector<TileFragments> tiles = trace_tiles(view, film, control, statistics);
    const ClusterPoints points(solution, control);
    const NodeOrder order(hierarchy_of(solution));
    const auto make = [&] { return std::make_unique<FullGatherer>(solution, order, points, view.tracer, samples); };
    return light_tiles(view, tiles, make, film, control, statistics);
}

ViewCounts grid_gather(const Solution& solution, const View& view, const GatherSettings& settings, std::uint32_t width,
                       std::uint32_t height, Film& film, Control& control, Statistics& statistics) {
    const std::vector<TileFragments> tiles = trace_tiles(view, film, control, statistics);
    const ClusterPoints points(solution, control);
    const NodeOrder order(hierarchy_of(solution));
    GridSettings cells;
    cells.cell = settings.cell * static_cast<float>(std::min(width, height)) / kStandardHeight;
    cells.law = view.camera.is_perspective() ? settings.law : DepthLaw::kLinear;
    const PerspectiveGrid grid = fit_grid(view, static_cast<float>(width), static_cast<float>(height), tiles, cells);
    const GridReceivers receivers(solution, grid, tiles, control);
    std::vector<Site> sites(receivers.site_count());
    {
        const StageTimer timer(statistics, "classification");
        ClassifySettings classify;
        classify.samples = settings.samples;
        classify.threshold = settings.threshold;
        classify.mean_radiosity = receivers.mean_radiosity();
        GatherCounts total;
        if (settings.free_space) {
            total = make_sites([&] { return FreeSpaceClassifier(solution, order, points, view.tracer, classify); },
                               [&](FreeSpaceClassifier& classifier, std::size_t i) {
                                   return classifier.classify(free_space_around(grid, receivers, i));
                               },
                               sites, control);
        } else {
            total =
                make_sites([&] { return Classifier(solution, order, points, view.tracer, classify); },
                           [&](Classifier& classifier, std::size_t i) { return classifier.classify(receivers.of(i)); },
                           sites, control);
        }
        report_sites(total, grid, statistics);
    }
    const Shader shader(solution, order, points, view.tracer);
    const auto make = [&] { return std::make_unique<GridGatherer>(grid, receivers, sites, shader); };
    return light_tiles(view, tiles, make, film, control, statistics);
}

}  // namespace gg
