#include "scene/weld.h"

#include <bit>

#include "core/random.h"
#include "scene/description.h"

namespace gg {

namespace {

std::uint64_t hash_position(Vec3 p) {
    const Vec3 unsigned_zero = p + 0.0F;  // -0 + 0 = 0
    const auto bits = [](float x) { return std::uint64_t{std::bit_cast<std::uint32_t>(x)}; };
    return hash64(bits(unsigned_zero.x) << 32 | bits(unsigned_zero.y), bits(unsigned_zero.z));
}

}  // namespace

std::vector<std::uint32_t> weld_positions(std::span<const Vec3> positions) {
    // Open addressing, at most half full: a vertex sits at its hash or in the next free slot.
    std::vector<std::uint32_t> table(std::bit_ceil(2 * positions.size() + 2), kNone);
    const std::size_t mask = table.size() - 1;
    std::vector<std::uint32_t> welded(positions.size());
    for (std::uint32_t vertex = 0; vertex < positions.size(); ++vertex) {
        std::size_t slot = hash_position(positions[vertex]) & mask;
        while (table[slot] != kNone && positions[table[slot]] != positions[vertex]) {
            slot = (slot + 1) & mask;
        }
        if (table[slot] == kNone) {
            table[slot] = vertex;
        }
        welded[vertex] = table[slot];
    }
    return welded;
}

}  // namespace gg
