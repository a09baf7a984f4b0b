// Pictures by final gather.
#pragma once

#include "film/film.h"
#include "film/solution_view.h"
#include "radiosity/solution.h"

namespace gg {

class Control;
class Statistics;

// Every sender anew at every fragment. Fills every tile of the film. Reports stage progress. Throws Cancelled.
ViewCounts full_gather(const Solution& solution, const View& view, Film& film, Control& control,
                       Statistics& statistics);

}  // namespace gg
