#include "gather/closer_look.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "gather/surroundings.h"
#include "transport/sky_cell.h"

namespace gg {

namespace {

// As few cells as can be, so that the variances of the others sum to at most `most`.
TableCellSet largest(const std::array<float, kTableCells>& variances, float most) {
    std::array<std::uint32_t, kTableCells> order;
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return variances[a] > variances[b]; });
    float rest = std::accumulate(variances.begin(), variances.end(), 0.0F);
    TableCellSet cells;
    for (const std::uint32_t cell : order) {
        if (rest <= most || variances[cell] <= 0) {
            break;
        }
        cells.set(cell);
        rest -= variances[cell];
    }
    return cells;
}

}  // namespace

float ray_variance(float irradiance, float radiosity, std::uint32_t cells) {
    return irradiance * 4 * radiosity / static_cast<float>(cells);
}

TableCellSet worth_closer_look(const Solution& solution, Vec3 from, std::span<const LeftSender> left, float error) {
    std::array<float, kTableCells> variances{};
    for (const LeftSender& sender : left) {
        const Vec3 to = hierarchy_of(solution)[sender.sender].center - from;
        const float variance =
            ray_variance(sender.irradiance, luminance(radiosity_of(solution, sender.sender)), kSiteCells);
        variances[table_index(finest_cell_at(normalize_or_zero(to)))] += variance;
    }
    return largest(variances, error * error);
}

TableCellSet worth_close_cells(const Surroundings& around, std::span<const RankRange> apart,
                               const DirectionTable& table, const Reach& reach, float error) {
    struct Sums {
        float count = 0, change = 0, squared = 0;
    };
    std::array<Sums, kTableCells> sums{};
    for (const RayOrigin& origin : around.origins()) {
        sums[table_index(site_cell(origin.cell))].count += 1;
    }
    for (const Met& met : around.met()) {
        const std::uint32_t cell = table_index(site_cell(met.cell));
        const float light = holds(apart, met.rank) ? 0.0F : kTableSolidAngle * luminance(met.radiance);
        const float change = reach.nearness(met.distance) * (light - luminance(table.at(cell)));
        sums[cell].change += change;
        sums[cell].squared += change * change;
    }
    std::array<float, kTableCells> variances{};
    for (std::uint32_t c = 0; c < kTableCells; ++c) {
        const float count = std::max(1.0F, sums[c].count), mean = sums[c].change / count;
        variances[c] = std::max(0.0F, sums[c].squared / count - mean * mean);
    }
    return largest(variances, error * error);
}

}  // namespace gg
