// Where a site's rays in fixed directions are too few: bright things that are met by few of them.
#pragma once

#include <span>

#include "core/vec.h"
#include "gather/direction_table.h"
#include "gather/surroundings.h"
#include "radiosity/solution.h"

namespace gg {

// A sender that the rays have to find: no site holds it by itself.
struct LeftSender {
    NodeId sender = kNone;
    float irradiance = 0;  // luminance that it may bring to the site, W/m2
};

// Variance of the irradiance that rays, one into each of `cells` equal parts of all directions, find of a sender: they
// meet it E / e times, and each time they find e = 4 B / cells, all that comes out of one part; E: its irradiance, B:
// its radiosity [W/m2]. Some parts lie in it wholly, so it is less than that.
[[nodiscard]] float ray_variance(float irradiance, float radiosity, std::uint32_t cells);

// Table cells that need more rays so that all senders that lie elsewhere leave a standard deviation of at most `error`
// [W/m2]: as few cells as can be. It goes by what the solution knows of senders, and not by what the rays met, as
// directions whose rays happened to miss something bright would then stay too dark.
[[nodiscard]] TableCellSet worth_closer_look(const Solution& solution, Vec3 from, std::span<const LeftSender> left,
                                             float error);

// Cells of near ones into which a point has to look more than once for what is near, so that what it finds there has
// a standard deviation of at most `error` [W/m2]. It goes by what a site's rays met; points have rays of their own.
[[nodiscard]] TableCellSet worth_close_cells(const Surroundings& around, std::span<const RankRange> apart,
                                             const DirectionTable& table, const Reach& reach, float error);

}  // namespace gg
