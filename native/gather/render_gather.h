// Pictures by final gather.
#pragma once

#include "film/film.h"
#include "film/solution_view.h"
#include "gather/perspective_grid.h"
#include "gather/site_thresholds.h"
#include "radiosity/solution.h"

namespace gg {

class Control;
class Statistics;

// Where the paper is left, and how finely [Scheel et al. 2002].
struct GatherSettings {
    bool free_space = false;  // sites look from points in free space and count hits, not from what is seen
    bool surfaces = true;     // fine elements have sites of their own
    bool shared = true;       // points take over what those around them agree about
    DepthLaw law = DepthLaw::kLogarithmic;
    float cell = 20;  // side of a grid cell, pixels of a picture that is 350 pixels high, or wide if that is less
    float threshold = 0.03F;  // see ClassifySettings
    int samples = 512;        // the same
};

// What the solution says of where rays meet surfaces; it must outlive this.
[[nodiscard]] IrradianceAt irradiance_by(const Solution& solution);

// All of these fill every tile of the film, report stage progress, and throw Cancelled.

// Models of the light at sites of a grid, blended at every fragment. observer: who tells which errors count; null: the
// settings' threshold does. width, height: of the full picture, pixels.
ViewCounts grid_gather(const Solution& solution, const View& view, const GatherSettings& settings,
                       const Observer* observer, std::uint32_t width, std::uint32_t height, Film& film,
                       Control& control, Statistics& statistics);

// Every sender anew at every fragment; samples: visibility rays from a point, about.
ViewCounts full_gather(const Solution& solution, const View& view, int samples, Film& film, Control& control,
                       Statistics& statistics);

}  // namespace gg
