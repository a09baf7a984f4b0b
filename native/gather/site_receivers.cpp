#include "gather/site_receivers.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/parallel.h"
#include "core/random.h"
#include "trace/surface_point.h"

namespace gg {

namespace {

constexpr std::size_t kReceivers = 200;  // of a site
constexpr float kStrict = 4;             // power of the mean of elevations: nearer to the least of them

// A fragment next to a vertex.
struct Candidate {
    std::uint32_t vertex = 0;
    std::uint32_t repeats = 0;  // how many of the same place come before it
    std::uint32_t rank = 0;     // by chance
    NodeId place = kNone;
    std::uint32_t tile = 0, fragment = 0;
};

bool is_before(const Candidate& a, const Candidate& b) {
    return std::tie(a.vertex, a.repeats, a.rank) < std::tie(b.vertex, b.repeats, b.rank);
}

// Leaves few of every vertex, and as many places as there are: each has senders of its own.
void thin_out(std::vector<Candidate>& all) {
    std::sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
        return std::tie(a.vertex, a.place, a.rank) < std::tie(b.vertex, b.place, b.rank);
    });
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool again = i > 0 && all[i].vertex == all[i - 1].vertex && all[i].place == all[i - 1].place;
        all[i].repeats = again ? all[i - 1].repeats + 1 : 0;
    }
    std::sort(all.begin(), all.end(), is_before);
    std::size_t kept = 0, of_vertex = 0;
    std::uint32_t vertex = kNone;
    for (const Candidate& candidate : all) {
        of_vertex = candidate.vertex == vertex ? of_vertex + 1 : 0;
        vertex = candidate.vertex;
        if (of_vertex < kReceivers) {
            all[kept++] = candidate;
        }
    }
    all.resize(kept);
}

// Sums over fragments next to a vertex.
struct ViewSum {
    std::uint32_t vertex = 0;
    float weight = 0;  // shares of pixels
    Rgb radiance{0.0F};
    float adaptation = 0, sensitivity = 0;  // the latter: elevation to the power of -kStrict

    void operator+=(const ViewSum& other) {
        weight += other.weight;
        radiance += other.radiance;
        adaptation += other.adaptation;
        sensitivity += other.sensitivity;
    }
};

// One per vertex, in ascending order, from sums that are in no order but stay in that of equal vertices.
void combine(std::vector<ViewSum>& sums) {
    std::stable_sort(sums.begin(), sums.end(), [](const ViewSum& a, const ViewSum& b) { return a.vertex < b.vertex; });
    std::size_t kept = 0;
    for (const ViewSum& sum : sums) {
        if (kept > 0 && sums[kept - 1].vertex == sum.vertex) {
            sums[kept - 1] += sum;
        } else {
            sums[kept++] = sum;
        }
    }
    sums.resize(kept);
}

ViewSum view_of(const Solution& solution, const TileFragments& tile, std::size_t pixel, const Fragment& at,
                const MaskingMap& seen) {
    const std::size_t x = tile.tile.x + pixel % tile.tile.width, y = tile.tile.y + pixel / tile.tile.width;
    const std::size_t i = y * seen.width + x;
    return {0, at.share, at.albedo * irradiance_at(solution, at) / kPi, at.share * seen.adaptation[i],
            at.share * std::pow(seen.elevation[i], -kStrict)};
}

std::vector<Candidate> candidates_of(const Solution& solution, const SitePlaces& places, const TileFragments& tile,
                                     std::uint32_t index, const MaskingMap* seen, std::vector<ViewSum>& sums) {
    std::vector<Candidate> found;
    std::size_t pixel = 0;
    for (std::uint32_t f = 0; f < tile.fragments.size(); ++f) {
        while (f >= tile.pixels[pixel].end) {
            ++pixel;
        }
        const Fragment& at = tile.fragments[f];
        const SitePlace place = places.of(at);
        const NodeId node = place_at(solution, at.hit.instance, at.hit.triangle, at.back, at.position);
        const auto rank = static_cast<std::uint32_t>(hash64(index, f));
        for (std::uint32_t k = 0; k < place.count; ++k) {
            found.push_back({place.vertices[k], 0, rank, node, index, f});
        }
        if (seen != nullptr) {
            ViewSum sum = view_of(solution, tile, pixel, at, *seen);
            for (std::uint32_t k = 0; k < place.count; ++k) {
                sum.vertex = place.vertices[k];
                sums.push_back(sum);
            }
        }
    }
    combine(sums);
    thin_out(found);
    return found;
}

}  // namespace

Receiver SiteReceivers::receiver(const SeenPlace& seen) const {
    const Fragment& at = tiles_[seen.tile].fragments[seen.fragment];
    Receiver receiver;
    receiver.position = offset_origin(at.position, at.normal, 1);
    receiver.normal = at.normal;
    receiver.shading_normal = at.shading_normal;
    receiver.place = seen.place;
    receiver.reflectance = luminance(at.albedo) / std::max(at.share, 1e-6F);
    receiver.irradiance = luminance(irradiance_at(solution_, at));
    receiver.pixel = camera_.pixel_size(at.hit.distance);
    return receiver;
}

std::vector<Receiver> SiteReceivers::of(std::size_t site) const {
    std::vector<Receiver> found;
    for (std::uint32_t i = begin_[site]; i < begin_[site + 1]; ++i) {
        found.push_back(receiver(seen_[i]));
    }
    return found;
}

SiteReceivers::SiteReceivers(const Solution& solution, const View& view, const SitePlaces& places,
                             std::span<const TileFragments> tiles, const MaskingMap* seen, const Control& control)
    : solution_(solution), camera_(view.camera), tiles_(tiles) {
    std::vector<std::vector<ViewSum>> sums(tiles.size());
    std::vector<Candidate> all = parallel_collect<Candidate>(
        tiles.size(), 1, control, [&](std::size_t begin, std::size_t end, std::vector<Candidate>& out) {
            for (std::size_t i = begin; i < end; ++i) {
                const auto found =
                    candidates_of(solution, places, tiles[i], static_cast<std::uint32_t>(i), seen, sums[i]);
                out.insert(out.end(), found.begin(), found.end());
            }
        });
    thin_out(all);
    seen_.resize(all.size());
    std::vector<float> reflected(all.size());  // W/m2
    parallel_for(all.size(), 256, control, [&](std::size_t i) {
        seen_[i] = {all[i].tile, all[i].fragment, all[i].place};
        const Receiver at = receiver(seen_[i]);
        reflected[i] = at.reflectance * at.irradiance;
    });
    site_of_.assign(places.vertex_count(), kNone);
    double radiosity = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        radiosity += static_cast<double>(reflected[i]);
        if (i == 0 || all[i].vertex != all[i - 1].vertex) {
            site_of_[all[i].vertex] = static_cast<std::uint32_t>(begin_.size() - 1);
            begin_.push_back(0);
            vertices_.push_back(all[i].vertex);
        }
        begin_.back() = static_cast<std::uint32_t>(i + 1);
    }
    if (seen != nullptr) {
        std::vector<ViewSum> together;
        for (const std::vector<ViewSum>& of_tile : sums) {
            together.insert(together.end(), of_tile.begin(), of_tile.end());
        }
        combine(together);
        for (const ViewSum& sum : together) {
            const float share = 1 / std::max(sum.weight, 1e-20F);
            views_.push_back({share * sum.radiance, share * sum.adaptation,
                              std::pow(sum.weight / std::max(sum.sensitivity, 1e-20F), 1 / kStrict)});
        }
    }
    mean_radiosity_ = static_cast<float>(radiosity / static_cast<double>(std::max<std::size_t>(all.size(), 1)));
}

}  // namespace gg
