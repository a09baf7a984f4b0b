#include "gather/closer_look.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "gather/surroundings.h"
#include "transport/sky_cell.h"

namespace gg {

float ray_variance(float irradiance, float radiosity, std::uint32_t cells) {
    return irradiance * 4 * radiosity / static_cast<float>(cells);
}

TableCellSet worth_closer_look(const Solution& solution, Vec3 from, std::span<const LeftSender> left, float error) {
    std::array<float, kTableCells> variances{};
    float rest = 0;
    for (const LeftSender& sender : left) {
        const Vec3 to = hierarchy_of(solution)[sender.sender].center - from;
        const float variance =
            ray_variance(sender.irradiance, luminance(radiosity_of(solution, sender.sender)), kSiteCells);
        variances[table_index(finest_cell_at(normalize_or_zero(to)))] += variance;
        rest += variance;
    }
    std::array<std::uint32_t, kTableCells> order;
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return variances[a] > variances[b]; });
    TableCellSet cells;
    for (const std::uint32_t cell : order) {
        if (rest <= error * error || variances[cell] <= 0) {
            break;
        }
        cells.set(cell);
        rest -= variances[cell];
    }
    return cells;
}

}  // namespace gg
