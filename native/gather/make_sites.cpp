#include "gather/make_sites.h"

#include <cstdint>
#include <mutex>
#include <optional>

#include "core/control.h"
#include "core/parallel.h"
#include "core/random.h"
#include "core/statistics.h"
#include "gather/free_space.h"

namespace gg {

namespace {

constexpr std::size_t kSitesAtOnce = 64;
constexpr std::uint64_t kFreeSpaceSeed = 0x66726565;

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
                             const ClassifySettings& settings, bool free_space, const Control& control,
                             Statistics& statistics) {
    std::vector<Site> sites(receivers.site_count());
    std::mutex mutex;
    GatherCounts total;
    std::uint64_t on_grid = 0;
    parallel_blocks(sites.size(), kSitesAtOnce, control, [&](std::size_t begin, std::size_t end) {
        Classifier from_seen(solution, order, points, tracer, settings);
        std::optional<FreeSpaceClassifier> from_space;
        if (free_space) {
            from_space.emplace(solution, order, points, tracer, settings);
        }
        std::uint64_t of_grid = 0;
        for (std::size_t i = begin; i < end; ++i) {
            control.check_cancel();
            const std::uint32_t vertex = receivers.vertex_of(i);
            const bool grid = places.is_of_grid(vertex);
            sites[i] = grid && from_space
                           ? from_space->classify(free_space_around(places.grid(), vertex, receivers.of(i)))
                           : from_seen.classify(receivers.of(i));
            of_grid += grid ? 1 : 0;
        }
        const std::scoped_lock lock(mutex);
        total += from_seen.counts();
        if (from_space) {
            total += from_space->counts();
        }
        on_grid += of_grid;
    });
    report(total, on_grid, places, statistics);
    return sites;
}

}  // namespace gg
