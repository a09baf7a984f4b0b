#include "gather/sky_leaves.h"

#include <algorithm>

#include "core/random.h"

namespace gg {

namespace {

constexpr std::uint32_t kFirstRays = 2, kLeafRays = 4;
constexpr std::uint8_t kFinest = 10;
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

SkyLeaves::SkyLeaves(const RayTracer& tracer, Rgb radiance) : tracer_(tracer), radiance_(radiance) {}

void SkyLeaves::look_into(std::span<const SkyCell> cells, std::uint32_t count, std::span<const Receiver> receivers) {
    rays_.clear();
    owners_.clear();
    looks_.assign(cells.size(), {});
    std::size_t next = 0;
    for (std::uint32_t c = 0; c < cells.size(); ++c) {
        const Sequence4 places(hash64(id_of(cells[c]), kLookSeed));
        for (std::uint32_t k = 0; k < count; ++k) {
            const Vec3 direction = cell_direction(cells[c], places(k, 0), places(k, 1));
            for (std::size_t tried = 0; tried < receivers.size(); ++tried) {
                const Receiver& receiver = receivers[next++ % receivers.size()];
                if (receiver.faces(direction)) {
                    rays_.push_back({receiver.position, direction, 0, kInfinity});
                    owners_.push_back(c);
                    break;
                }
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
    // -1: nobody looks there, 0: hidden, 1: seen, 2: both.
    std::vector<int> state(kSiteCells, -1);
    for (std::uint32_t c = 0; c < kSiteCells; ++c) {
        const Seen seen = around.seen()[c];
        const std::uint32_t rays = looks_[c].rays + (seen != Seen::kNothing),
                            misses = looks_[c].misses + (seen == Seen::kSky);
        if (rays > 0) {
            state[c] = misses == 0 ? 0 : (misses == rays ? 1 : 2);
        }
    }
    finer_.clear();
    for (std::uint32_t c = 0; c < kSiteCells; ++c) {
        const SkyCell cell = site_cell(c);
        bool even = state[c] != 2;
        for (int dj = -1; dj <= 1 && even; ++dj) {
            for (int di = -1; di <= 1; ++di) {
                const int i = cell.i + di, j = cell.j + dj;
                if (i >= 0 && j >= 0 && i < static_cast<int>(kSiteSide) && j < static_cast<int>(kSiteSide)) {
                    const int other = state[site_index(
                        {kSiteLevel, cell.face, static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j)})];
                    even = even && (other < 0 || other == state[c]);
                }
            }
        }
        if (!even && state[c] >= 0) {
            finer_.push_back(cell);
        } else if (state[c] == 1) {
            table.add(table_index(cell), cell_solid_angle(cell) * radiance_);
        }
    }
    while (!finer_.empty() && cell_solid_angle(finer_.front()) > size && finer_.front().level < kFinest) {
        cells_.clear();
        for (const SkyCell cell : finer_) {
            for (const SkyCell child : children(cell)) {
                cells_.push_back(child);
            }
        }
        // Parts that all agree are not divided again.
        look_into(cells_, kLeafRays, receivers);
        finer_.clear();
        for (std::size_t c = 0; c < cells_.size(); ++c) {
            if (looks_[c].misses > 0 && looks_[c].misses < looks_[c].rays) {
                finer_.push_back(cells_[c]);
            } else if (looks_[c].misses > 0) {
                table.add(table_index(cells_[c]), cell_solid_angle(cells_[c]) * radiance_);
            }
        }
    }
    for (const SkyCell cell : finer_) {
        leaves.push_back(make_leaf(cell));
    }
    std::sort(leaves.begin(), leaves.end(), [](const SkyLeaf& a, const SkyLeaf& b) { return a.id < b.id; });
}

}  // namespace gg
