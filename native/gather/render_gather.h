// Pictures by final gather.
#pragma once

#include "film/film.h"
#include "film/solution_view.h"
#include "radiosity/solution.h"

namespace gg {

class Control;
class Statistics;

// All of these fill every tile of the film, report stage progress, and throw Cancelled.

// Models of the light at sites of a grid, blended at every fragment. width, height: of the full picture, pixels.
ViewCounts grid_gather(const Solution& solution, const View& view, std::uint32_t width, std::uint32_t height,
                       Film& film, Control& control, Statistics& statistics);

// Every sender anew at every fragment.
ViewCounts full_gather(const Solution& solution, const View& view, Film& film, Control& control,
                       Statistics& statistics);

}  // namespace gg
