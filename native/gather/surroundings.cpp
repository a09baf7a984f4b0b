#include "gather/surroundings.h"

#include <array>
#include <utility>

#include "core/random.h"

namespace gg {

namespace {

constexpr float kDoubt = 2;  // rays: one that passes by what is near says little of a whole cell
constexpr std::uint64_t kSiteSeed = 0x73697465, kNearSeed = 0x6e656172, kCloseSeed = 0x636c6f73;

// Cells of a level so that every aligned run of 4^n is a square.
std::vector<SkyCell> in_squares(std::uint8_t level) {
    std::vector<SkyCell> cells;
    for (const SkyCell root : sky_roots()) {
        cells.push_back(root);
    }
    for (std::uint8_t k = 0; k < level; ++k) {
        std::vector<SkyCell> finer;
        for (const SkyCell cell : cells) {
            const auto parts = children(cell);
            finer.insert(finer.end(), parts.begin(), parts.end());
        }
        cells = std::move(finer);
    }
    return cells;
}

}  // namespace

Vec3 near_direction(std::uint32_t index) {
    const Sequence4 places(kNearSeed);
    return cell_direction(table_cell(index), places(index, 0), places(index, 1));
}

std::array<Vec3, kCloseRays> close_directions(std::uint32_t index) {
    const Sequence4 places(kCloseSeed);
    const auto parts = children(table_cell(index));
    std::array<Vec3, kCloseRays> directions;
    for (std::uint32_t k = 0; k < parts.size(); ++k) {
        directions[k] = cell_direction(parts[k], places(kCloseRays * index + k, 0), places(kCloseRays * index + k, 1));
    }
    return directions;
}

Surroundings::Surroundings(const Solution& solution, const NodeOrder& order, const RayTracer& tracer)
    : solution_(solution), order_(order), tracer_(tracer) {
    const Sequence4 sites(kSiteSeed);
    for (const SkyCell cell : in_squares(kSiteLevel)) {
        const std::uint32_t c = site_index(cell);
        site_directions_.push_back({c, cell_direction(cell, sites(c, 0), sites(c, 1))});
        for (const SkyCell child : children(cell)) {
            const auto place = static_cast<std::uint32_t>(kSiteCells + closer_directions_.size());
            closer_directions_.push_back({c, cell_direction(child, sites(place, 0), sites(place, 1))});
        }
    }
    for (const SkyCell cell : in_squares(kTableLevel)) {
        const std::uint32_t c = table_index(cell);
        near_directions_.push_back({c, near_direction(c)});
        for (const Vec3 direction : close_directions(c)) {
            near_directions_.push_back({c, direction, true});
        }
    }
}

void Surroundings::trace(std::size_t first) {
    hits_.resize(rays_.size());
    tracer_.closest_hits(std::span(rays_).subspan(first), std::span(hits_).subspan(first), RayMask::kLight,
                         Coherence::kIncoherent);
    const Hierarchy& hierarchy = hierarchy_of(solution_);
    for (std::size_t i = first; i < rays_.size(); ++i) {
        const Hit& hit = hits_[i];
        if (hit.missed()) {
            continue;
        }
        const bool back = dot(world_area_vector(hierarchy.scene(), hit.instance, hit.triangle), rays_[i].direction) > 0;
        const LitPlace lit = lit_place(solution_, hit, back);
        met_.push_back({origins_[i].point, origins_[i].cell, lit.place != kNone ? order_.rank(lit.place) : 0,
                        hit.distance, lit.radiosity / kPi, origins_[i].close});
    }
}

void Surroundings::look_from(std::span<const Receiver> receivers) {
    rays_.clear();
    origins_.clear();
    met_.clear();
    seen_.assign(kSiteCells, Seen::kNothing);
    ReceiverTurns turns(receivers);
    for (const auto& [cell, direction, close] : site_directions_) {
        if (const Receiver* receiver = turns.next(direction)) {
            rays_.push_back({receiver->position, direction, 0, kInfinity});
            origins_.push_back({0, cell});
            seen_[cell] = Seen::kSky;
        }
    }
    trace(0);
    for (const Met& met : met_) {
        seen_[met.cell] = Seen::kSurface;
    }
}

void Surroundings::look_closer(std::span<const Receiver> receivers, const TableCellSet& cells) {
    const std::size_t first = rays_.size();
    ReceiverTurns turns(receivers);
    for (const auto& [cell, direction, close] : closer_directions_) {
        if (cells[table_index(site_cell(cell))]) {
            if (const Receiver* receiver = turns.next(direction)) {
                rays_.push_back({receiver->position, direction, 0, kInfinity});
                origins_.push_back({0, cell});
            }
        }
    }
    trace(first);
}

void Surroundings::add_to(DirectionTable& table, std::span<const RankRange> apart, const Reach& reach) const {
    struct Sum {
        Rgb far{0.0F}, all{0.0F};
        float far_count = 0, count = 0;
    };
    std::array<Sum, kTableCells> sums;
    for (const RayOrigin& origin : origins_) {
        Sum& sum = sums[table_index(site_cell(origin.cell))];
        sum.count += 1;
        sum.far_count += 1;
    }
    for (const Met& met : met_) {
        Sum& sum = sums[table_index(site_cell(met.cell))];
        const Rgb radiance = holds(apart, met.rank) ? Rgb(0.0F) : met.radiance;
        const float far = 1 - reach.nearness(met.distance);
        sum.all += radiance;
        sum.far += far * radiance;
        sum.far_count += far - 1;
    }
    for (std::uint32_t c = 0; c < kTableCells; ++c) {
        const Sum& sum = sums[c];
        if (sum.count > 0) {
            const Rgb mean = sum.all / sum.count;
            table.add(c, kTableSolidAngle / (sum.far_count + kDoubt) * (sum.far + kDoubt * mean));
        }
    }
}

TableCellSet Surroundings::near_cells(float distance) const {
    TableCellSet cells;
    for (const Met& met : met_) {
        if (met.distance < distance) {
            cells.set(table_index(site_cell(met.cell)));
        }
    }
    return cells;
}

void Surroundings::look_near(std::span<const NearPoint> points) {
    rays_.clear();
    origins_.clear();
    met_.clear();
    for (const auto& [cell, direction, close] : near_directions_) {
        for (std::uint32_t p = 0; p < points.size(); ++p) {
            const TableCellSet& cells = close ? points[p].close_cells : points[p].cells;
            if (cells[cell] && dot(direction, points[p].normal) > 0) {
                rays_.push_back({points[p].position, direction, 0, points[p].reach});
                origins_.push_back({p, cell, close});
            }
        }
    }
    trace(0);
}

}  // namespace gg
