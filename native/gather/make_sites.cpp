#include "gather/make_sites.h"

#include <cstdint>
#include <memory>
#include <optional>

#include "core/control.h"
#include "core/parallel.h"
#include "core/pool.h"
#include "core/random.h"
#include "core/statistics.h"
#include "gather/free_space.h"

namespace gg {

namespace {

constexpr std::size_t kSitesAtOnce = 16;
constexpr std::uint64_t kFreeSpaceSeed = 0x66726565;

struct Worker {
    explicit Worker(Classifier classifier) : from_seen(std::move(classifier)) {}

    Classifier from_seen;
    std::optional<FreeSpaceClassifier> from_space;
    std::uint64_t on_grid = 0;  // sites
};

// Points in the cells around a vertex of the grid.
FreeSpace free_space_around(const PerspectiveGrid& grid, std::uint32_t vertex, std::span<const Receiver> receivers) {
    const Sequence4 places(hash64(vertex, kFreeSpaceSeed));
    FreeSpace space{grid.near_vertex(vertex, Vec3(0.0F)), {}, receivers};
    for (std::uint32_t i = 0; i < FreeSpaceClassifier::kMostPoints; ++i) {
        space.points.push_back(
            grid.near_vertex(vertex, 2.0F * Vec3(places(i, 0), places(i, 1), places(i, 2)) - Vec3(1.0F)));
    }
    return space;
}

void report(const GatherCounts& total, std::uint64_t on_grid, const SitePlaces& places, Statistics& statistics) {
    statistics.set_count("sites", static_cast<double>(total.points));
    statistics.set_count("grid vertices", static_cast<double>(places.grid().vertex_count()));
    statistics.set_count("sites on the grid", static_cast<double>(on_grid));
    statistics.set_count("sites on surfaces", static_cast<double>(total.points - on_grid));
    statistics.set_count("senders of sites", static_cast<double>(total.senders));
    statistics.set_count("rays of classification", static_cast<double>(total.visibility_rays + total.near_rays));
    statistics.set_count("senders resampled: both", static_cast<double>(total.both));
    statistics.set_count("senders resampled: visibility", static_cast<double>(total.only_visibility));
    statistics.set_count("senders resampled: form factor", static_cast<double>(total.only_form_factor));
}

}  // namespace

std::vector<Site> make_sites(const Solution& solution, const NodeOrder& order, const ClusterPoints& points,
                             const RayTracer& tracer, const SitePlaces& places, const SiteReceivers& receivers,
                             const ClassifySettings& settings, std::span<const float> thresholds, bool free_space,
                             const Control& control, Statistics& statistics) {
    std::vector<Site> sites(receivers.site_count());
    Pool<Worker> workers([&] {
        auto worker = std::make_unique<Worker>(Classifier(solution, order, points, tracer, settings));
        if (free_space) {
            worker->from_space.emplace(solution, order, points, tracer, settings);
        }
        return worker;
    });
    parallel_blocks(sites.size(), kSitesAtOnce, control, [&](std::size_t begin, std::size_t end) {
        workers.use([&](Worker& worker) {
            for (std::size_t i = begin; i < end; ++i) {
                control.check_cancel();
                const std::uint32_t vertex = receivers.vertex_of(i);
                const bool grid = places.is_of_grid(vertex);
                const std::vector<Receiver> seen = receivers.of(i);
                const float threshold = thresholds.empty() ? 0 : thresholds[i];
                sites[i] = grid && worker.from_space
                               ? worker.from_space->classify(free_space_around(places.grid(), vertex, seen), threshold)
                               : worker.from_seen.classify(seen, threshold);
                worker.on_grid += grid ? 1 : 0;
            }
        });
    });
    GatherCounts total;
    std::uint64_t on_grid = 0;
    for (const auto& worker : workers.all()) {
        total += worker->from_seen.counts();
        if (worker->from_space) {
            total += worker->from_space->counts();
        }
        on_grid += worker->on_grid;
    }
    report(total, on_grid, places, statistics);
    return sites;
}

}  // namespace gg
