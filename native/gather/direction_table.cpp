#include "gather/direction_table.h"

#include <cmath>

namespace gg {

namespace {

struct CellShapes {
    alignas(32) std::array<float, kTableCells> x{}, y{}, z{};  // mean direction: shorter than unit, by the cell's width
    alignas(32) std::array<float, kTableCells> half{};  // half width of the cosines that a cell's directions have
};

CellShapes make_shapes() {
    constexpr int kSide = 16;
    CellShapes shapes;
    for (std::uint32_t c = 0; c < kTableCells; ++c) {
        Vec3 mean(0.0F);
        for (int k = 0; k < kSide * kSide; ++k) {
            mean += cell_direction(table_cell(c), (static_cast<float>(k % kSide) + 0.5F) / kSide,
                                   (static_cast<float>(k / kSide) + 0.5F) / kSide);
        }
        mean /= static_cast<float>(kSide * kSide);
        shapes.x[c] = mean.x;
        shapes.y[c] = mean.y;
        shapes.z[c] = mean.z;
        // Directions spread evenly over a square have cosines spread evenly, at variance half^2 / 3.
        shapes.half[c] = std::sqrt(1.5F * (1 - length_squared(mean)));
    }
    return shapes;
}

}  // namespace

TableCosines::TableCosines(Vec3 n) {
    static const CellShapes shapes = make_shapes();
    for (std::uint32_t c = 0; c < kTableCells; ++c) {
        const float s = shapes.x[c] * n.x + shapes.y[c] * n.y + shapes.z[c] * n.z, h = shapes.half[c];
        const float rise = std::max(0.0F, s + h);
        of[c] = s >= h ? s : rise * rise / (4 * h);  // of a cell on the horizon the part above it
    }
}

Rgb light_of(const DirectionTable& table, const TableCosines& cosines) {
    constexpr std::uint32_t kLanes = 8;
    std::array<float, kLanes> red{}, green{}, blue{};
    for (std::uint32_t c = 0; c < kTableCells; c += kLanes) {
        for (std::uint32_t k = 0; k < kLanes; ++k) {
            red[k] += cosines.of[c + k] * table.red[c + k];
            green[k] += cosines.of[c + k] * table.green[c + k];
            blue[k] += cosines.of[c + k] * table.blue[c + k];
        }
    }
    Rgb sum(0.0F);
    for (std::uint32_t k = 0; k < kLanes; ++k) {
        sum += Rgb(red[k], green[k], blue[k]);
    }
    return sum;
}

TableCellSet one_of_partners(const TableCellSet& cells) {
    static const TableCellSet black = [] {
        TableCellSet fields;
        for (std::uint32_t c = 0; c < kTableCells; ++c) {
            const SkyCell cell = table_cell(c);
            fields.set(c, (cell.i + cell.j) % 2 == 0);
        }
        return fields;
    }();
    static const TableCellSet first = [] {
        TableCellSet fields;
        for (std::uint32_t c = 0; c < kTableCells; ++c) {
            fields.set(c, c < table_partner(c));
        }
        return fields;
    }();
    return (cells | (cells & first) << 1 | (cells >> 1 & first)) & black;
}

}  // namespace gg
