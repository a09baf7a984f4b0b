#include "gather/sky_leaves.h"

#include <algorithm>

#include "core/random.h"

namespace gg {

namespace {

constexpr std::uint32_t kFirstRays = 2, kLeafRays = 4;  // into a cell of a site, besides its own; into a leaf
constexpr std::size_t kMostLeaves = 1024;  // where that many are reached, cells stay larger; 256 are 4 % further off
constexpr std::uint8_t kFinest = 9;        // level
constexpr int kAround = 2;                 // cells on each side that have to agree: with 1 small windows lose light
constexpr std::uint64_t kLookSeed = 0x736b7931, kLeafSeed = 0x736b7932;

std::uint32_t id_of(SkyCell cell) {
    return ((std::uint32_t{cell.face} << 10 | cell.j) << 10 | cell.i) << 4 | cell.level;
}

SkyLeaf make_leaf(SkyCell cell) {
    const std::uint32_t id = id_of(cell);
    const Sequence4 place(hash64(id, kLeafSeed));
    return {id, cell_direction(cell, place(0, 0), place(0, 1)), cell_solid_angle(cell)};
}

}  // namespace

SkyLeaves::State SkyLeaves::state_of(const Look& look) {
    if (look.rays == 0) {
        return State::kUnknown;
    }
    return look.misses == 0 ? State::kHidden : (look.misses == look.rays ? State::kSeen : State::kMixed);
}

SkyLeaves::SkyLeaves(const RayTracer& tracer, Rgb radiance) : tracer_(tracer), radiance_(radiance) {}

void SkyLeaves::look_into(std::span<const SkyCell> cells, std::uint32_t count, std::span<const Receiver> receivers) {
    rays_.clear();
    owners_.clear();
    looks_.assign(cells.size(), {});
    ReceiverTurns turns(receivers);
    for (std::uint32_t c = 0; c < cells.size(); ++c) {
        const Sequence4 places(hash64(id_of(cells[c]), kLookSeed));
        for (std::uint32_t k = 0; k < count; ++k) {
            const Vec3 direction = cell_direction(cells[c], places(k, 0), places(k, 1));
            if (const Receiver* receiver = turns.next(direction)) {
                rays_.push_back({receiver->position, direction, 0, kInfinity});
                owners_.push_back(c);
            }
        }
    }
    ray_count_ += rays_.size();
    blocked_.resize(rays_.size());
    tracer_.occluded(rays_, blocked_, RayMask::kLight, Coherence::kIncoherent);
    for (std::size_t i = 0; i < rays_.size(); ++i) {
        looks_[owners_[i]].rays += 1;
        looks_[owners_[i]].misses += blocked_[i] ? 0 : 1;
    }
}

void SkyLeaves::find(std::span<const Receiver> receivers, const Surroundings& around, float size,
                     std::vector<SkyLeaf>& leaves, DirectionTable& table) {
    leaves.clear();
    if (!(luminance(radiance_) > 0)) {
        return;
    }
    cells_.clear();
    for (std::uint32_t c = 0; c < kSiteCells; ++c) {
        cells_.push_back(site_cell(c));
    }
    look_into(cells_, kFirstRays, receivers);
    states_.assign(kSiteCells, State::kUnknown);
    for (std::uint32_t c = 0; c < kSiteCells; ++c) {
        const Seen seen = around.seen()[c];
        Look look = looks_[c];
        look.rays += seen != Seen::kNothing ? 1 : 0;
        look.misses += seen == Seen::kSky ? 1 : 0;
        states_[c] = state_of(look);
    }
    settle(kSiteLevel, table);
    std::uint8_t level = kSiteLevel;
    while (!finer_.empty() && cell_solid_angle(finer_.front()) > size && finer_.size() <= kMostLeaves / 4 &&
           level < kFinest) {
        ++level;
        cells_.clear();
        for (const SkyCell cell : finer_) {
            for (const SkyCell child : children(cell)) {
                cells_.push_back(child);
            }
        }
        finer_ = cells_;
    }
    if (level > kSiteLevel) {
        look_into(cells_, kLeafRays, receivers);
        states_.clear();
        for (const Look& look : looks_) {
            states_.push_back(state_of(look));
        }
        settle(level, table);
    }
    for (const SkyCell cell : finer_) {
        leaves.push_back(make_leaf(cell));
    }
    std::sort(leaves.begin(), leaves.end(), [](const SkyLeaf& a, const SkyLeaf& b) { return a.id < b.id; });
}

// Cells that agree with all their neighbours are settled; finer_ are the others.
void SkyLeaves::settle(std::uint8_t level, DirectionTable& table) {
    const int side = 1 << level;
    places_.assign(std::size_t{2} * side * side, kNone);
    const auto place = [&](int face, int i, int j) { return (static_cast<std::size_t>(face) * side + j) * side + i; };
    for (std::uint32_t c = 0; c < cells_.size(); ++c) {
        places_[place(cells_[c].face, cells_[c].i, cells_[c].j)] = c;
    }
    finer_.clear();
    for (std::uint32_t c = 0; c < cells_.size(); ++c) {
        const SkyCell cell = cells_[c];
        if (states_[c] == State::kUnknown) {
            continue;
        }
        bool even = states_[c] != State::kMixed;
        constexpr int kRow = 2 * kAround + 1;
        for (int k = 0; k < kRow * kRow && even; ++k) {
            const int i = cell.i + k % kRow - kAround, j = cell.j + k / kRow - kAround;
            const bool inside = i >= 0 && j >= 0 && i < side && j < side;
            const std::uint32_t other = inside ? places_[place(cell.face, i, j)] : kNone;
            even = other == kNone || states_[other] == State::kUnknown || states_[other] == states_[c];
        }
        if (!even) {
            finer_.push_back(cell);
        } else if (states_[c] == State::kSeen) {
            table.add(table_index(cell), cell_solid_angle(cell) * radiance_);
        }
    }
}

}  // namespace gg
