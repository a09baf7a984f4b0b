// Light from all around in a table of directions: the cells of the sky's quadtrees, so equal solid angles.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <span>

#include "core/vec.h"
#include "transport/sky_cell.h"

namespace gg {

inline constexpr std::uint8_t kTableLevel = 3;
inline constexpr std::uint32_t kTableSide = 1U << kTableLevel, kTableCells = 2 * kTableSide * kTableSide;
inline constexpr float kTableSolidAngle = 4 * kPi / kTableCells;  // of a cell, sr

[[nodiscard]] constexpr std::uint32_t table_index(SkyCell cell) {
    const int finer = cell.level - kTableLevel;
    return (cell.face * kTableSide + (cell.j >> finer)) * kTableSide + (cell.i >> finer);
}
[[nodiscard]] constexpr SkyCell table_cell(std::uint32_t index) {
    return {kTableLevel, static_cast<std::uint8_t>(index / (kTableSide * kTableSide)),
            static_cast<std::uint16_t>(index % kTableSide),
            static_cast<std::uint16_t>(index / kTableSide % kTableSide)};
}

using TableCellSet = std::bitset<kTableCells>;

// The cell beside it; partners of one another.
[[nodiscard]] constexpr std::uint32_t table_partner(std::uint32_t index) {
    return index ^ 1U;
}
// Of every pair of partners of which either is in the set one: all in all as the fields of one colour of a chessboard.
[[nodiscard]] TableCellSet one_of_partners(const TableCellSet& cells);

// Per cell: irradiance of a plane that faces it, W/m2.
struct DirectionTable {
    alignas(32) std::array<float, kTableCells> red{}, green{}, blue{};

    [[nodiscard]] Rgb at(std::uint32_t cell) const { return {red[cell], green[cell], blue[cell]}; }
    void add(std::uint32_t cell, Rgb irradiance) {
        red[cell] += irradiance.x;
        green[cell] += irradiance.y;
        blue[cell] += irradiance.z;
    }
};

// Mean over every cell of max(0, n.direction): what a plane with unit normal n receives of the table's values.
struct TableCosines {
    explicit TableCosines(Vec3 n);
    alignas(32) std::array<float, kTableCells> of{};
};

// Irradiance of that plane [W/m2].
[[nodiscard]] Rgb light_of(const DirectionTable& table, const TableCosines& cosines);

}  // namespace gg
