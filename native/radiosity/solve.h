// Hierarchical radiosity with clustering: from a scene to its converged lighting.
#pragma once

#include <memory>

#include "radiosity/solution.h"

namespace gg {

class Control;
class RayTracer;
class Statistics;
class SurfaceColors;
struct Scene;

struct SolveSettings {
    // Allowed error of a link as a share of the reference white (see reference_white.h); 0.001..1. Smaller is finer.
    float quality = 0.02F;
};

// Never fails on a valid scene; a scene without light has irradiance 0. Throws Cancelled.
[[nodiscard]] std::shared_ptr<const Solution> solve(const Scene& scene, const SurfaceColors& colors,
                                                    const RayTracer& tracer, const SolveSettings& settings,
                                                    Control& control, Statistics& statistics);

}  // namespace gg
