#include "gather/render_gather.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/control.h"
#include "core/parallel.h"
#include "core/statistics.h"
#include "gather/full_gather.h"
#include "gather/light_tiles.h"
#include "gather/make_sites.h"
#include "gather/shade.h"
#include "gather/site_places.h"

namespace gg {

namespace {

constexpr float kStandardHeight = 350;  // pixels, of pictures that settings are meant for
constexpr float kLeastCell = 4;         // pixels; in smaller ones little else is seen than what is looked at

// Of many things, each of which knows its own.
template <typename Things>
double bytes_of(const Things& things) {
    double sum = 0;
    for (const auto& thing : things) {
        sum += static_cast<double>(thing.bytes());
    }
    return sum;
}

std::vector<TileFragments> trace_tiles(const Solution& solution, const View& view, const Film& film, Control& control,
                                       Statistics& statistics) {
    const StageTimer timer(statistics, "visible points");
    const IrradianceAt expected = irradiance_by(solution);
    std::vector<TileFragments> tiles(film.tile_count());
    parallel_for(tiles.size(), 1, control, [&](std::size_t i) {
        tiles[i] = trace_tile(view, film.tile(static_cast<std::uint32_t>(i)), &expected);
    });
    statistics.set_bytes("fragments", bytes_of(tiles));
    return tiles;
}

class FullGatherer : public Gatherer {
  public:
    FullGatherer(const Solution& solution, const NodeOrder& order, const ClusterPoints& points, const RayTracer& tracer,
                 int samples)
        : solution_(solution), gather_(solution, order, points, tracer, samples) {}

    void shade(std::span<const Fragment> fragments, std::span<const KnownLight>, std::span<PointLight> light,
               std::span<PointCounts> taken) override {
        for (std::size_t i = 0; i < fragments.size(); ++i) {
            const GatherCounts before = gather_.counts();
            light[i].all = gather_.irradiance(fragments[i], luminance(irradiance_at(solution_, fragments[i])));
            const GatherCounts& now = gather_.counts();
            taken[i] = {static_cast<std::uint32_t>(now.visibility_rays + now.near_rays - before.visibility_rays -
                                                   before.near_rays),
                        static_cast<std::uint32_t>(now.form_factors - before.form_factors),
                        static_cast<std::uint32_t>(now.senders - before.senders)};
        }
    }
    void shade_parts(const Fragment&, Rgb, std::span<const Fragment> parts, std::span<PointLight> light,
                     std::span<PointCounts> taken) override {
        shade(parts, {}, light, taken);
    }
    [[nodiscard]] const GatherCounts& counts() const override { return gather_.counts(); }
    [[nodiscard]] std::uint32_t cell_of(const Fragment&) const override { return 0; }
    [[nodiscard]] float threshold_at(const Fragment&) const override { return 0; }

  private:
    const Solution& solution_;
    FullGather gather_;
};

class SiteGatherer : public Gatherer {
  public:
    // thresholds: per site, or none.
    SiteGatherer(const SitePlaces& places, const SiteReceivers& receivers, std::span<const Site> sites,
                 std::span<const float> thresholds, const Shader& shader)
        : places_(places), receivers_(receivers), sites_(sites), thresholds_(thresholds), shader_(shader) {}

    void shade(std::span<const Fragment> fragments, std::span<const KnownLight> known, std::span<PointLight> light,
               std::span<PointCounts> taken) override {
        placed_.clear();
        for (std::size_t i = 0; i < fragments.size(); ++i) {
            placed_.push_back(placed(fragments[i]));
            placed_.back().known = known[i];
        }
        shader_.shade(placed_, light, taken);
    }
    void shade_parts(const Fragment& whole, Rgb soft, std::span<const Fragment> parts, std::span<PointLight> light,
                     std::span<PointCounts> taken) override {
        placed_.clear();
        for (const Fragment& at : parts) {
            placed_.push_back(placed(has_all_sites(at) ? at : whole));
            placed_.back().at = at;
            placed_.back().known.soft = soft;
            placed_.back().part = static_cast<std::uint32_t>(placed_.size() - 1);
        }
        shader_.shade(placed_, light, taken);
    }
    [[nodiscard]] const GatherCounts& counts() const override { return shader_.counts(); }
    [[nodiscard]] std::uint32_t cell_of(const Fragment& fragment) const override {
        return places_.grid().cell_at(fragment.position);
    }
    [[nodiscard]] float threshold_at(const Fragment& fragment) const override {
        float sum = 0;
        if (!thresholds_.empty()) {
            const SitePlace place = places_.of(fragment);
            for (std::uint32_t k = 0; k < place.count; ++k) {
                sum += place.weights[k] * thresholds_[receivers_.site_at(place.vertices[k])];
            }
        }
        return sum;
    }

  private:
    [[nodiscard]] bool has_all_sites(const Fragment& at) const {
        const SitePlace place = places_.of(at);
        return std::all_of(place.vertices.begin(), place.vertices.begin() + place.count,
                           [&](std::uint32_t vertex) { return receivers_.site_at(vertex) != kNone; });
    }

    // Between sites that all exist: a whole fragment was a receiver of all of its own.
    [[nodiscard]] PlacedFragment placed(const Fragment& at) const {
        const SitePlace place = places_.of(at);
        PlacedFragment here{at, {}, place.count, place.on_surface, {}};
        for (std::uint32_t k = 0; k < place.count; ++k) {
            here.around[k] = {&sites_[receivers_.site_at(place.vertices[k])], place.weights[k]};
        }
        return here;
    }

    const SitePlaces& places_;
    const SiteReceivers& receivers_;
    std::span<const Site> sites_;
    std::span<const float> thresholds_;
    Shader shader_;
    std::vector<PlacedFragment> placed_;
};

}  // namespace

IrradianceAt irradiance_by(const Solution& solution) {
    return [&solution](const Hit& hit, bool back) {
        return interpolated_irradiance(solution, hit.instance, hit.triangle, back, {hit.u, hit.v});
    };
}

ViewCounts full_gather(const Solution& solution, const View& view, int samples, Film& film, Control& control,
                       Statistics& statistics) {
    const std::vector<TileFragments> tiles = trace_tiles(solution, view, film, control, statistics);
    const ClusterPoints points(solution, control);
    const NodeOrder order(hierarchy_of(solution));
    const auto make = [&] { return std::make_unique<FullGatherer>(solution, order, points, view.tracer, samples); };
    return light_tiles(view, tiles, nullptr, {}, make, film, control, statistics);
}

ViewCounts grid_gather(const Solution& solution, const View& view, const GatherSettings& settings,
                       const Observer* observer, std::uint32_t width, std::uint32_t height, Film& film,
                       Control& control, Statistics& statistics) {
    const std::vector<TileFragments> tiles = trace_tiles(solution, view, film, control, statistics);
    std::optional<StageTimer> timer;
    std::optional<MaskingMap> seen;
    if (observer != nullptr) {
        timer.emplace(statistics, "perception");
        seen = observe(*observer, solution, view, tiles, control);
        timer.reset();
    }
    const ClusterPoints points(solution, control);
    const NodeOrder order(hierarchy_of(solution));
    GridSettings cells;
    cells.cell = std::max(settings.cell * static_cast<float>(std::min(width, height)) / kStandardHeight, kLeastCell);
    cells.law = view.camera.is_perspective() ? settings.law : DepthLaw::kLinear;
    const PerspectiveGrid grid = fit_grid(view, static_cast<float>(width), static_cast<float>(height), tiles, cells);
    timer.emplace(statistics, "places of sites");
    std::optional<SurfaceMesh> surfaces;
    if (settings.surfaces) {
        surfaces.emplace(fit_surfaces(solution, grid, tiles, settings.free_space, control));
    }
    const SitePlaces places(grid, surfaces ? &*surfaces : nullptr);
    const SiteReceivers receivers(solution, view, places, tiles, seen ? &*seen : nullptr, control);
    timer.reset();
    timer.emplace(statistics, "classification");
    std::vector<float> thresholds;
    if (observer != nullptr) {
        thresholds = noticeable_radiosity(*observer, receivers.views(), view.settings.exposure, control);
    }
    ClassifySettings classify;
    classify.samples = settings.samples;
    classify.threshold = settings.threshold;
    classify.mean_radiosity = receivers.mean_radiosity();
    const std::vector<Site> sites = make_sites(solution, order, points, view.tracer, places, receivers, classify,
                                               thresholds, settings.free_space, control, statistics);
    timer.reset();
    statistics.set_bytes("sites",
                         bytes_of(sites) + static_cast<double>(receivers.bytes() + order.bytes() + points.bytes()));
    const Shader shader(solution, order, points, view.tracer);
    const auto make = [&] { return std::make_unique<SiteGatherer>(places, receivers, sites, thresholds, shader); };
    const Sharing sharing = settings.shared ? sharing_in(cells.cell, settings.threshold) : Sharing{};
    return light_tiles(view, tiles, seen ? &*seen : nullptr, sharing, make, film, control, statistics);
}

}  // namespace gg
