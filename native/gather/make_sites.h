// The models of the light at all sites of a picture.
#pragma once

#include <vector>

#include "gather/classify.h"
#include "gather/site_receivers.h"

namespace gg {

class Control;
class Statistics;

// thresholds: see Classifier, per site, or none. free_space: sites on the grid look from points in free space and count
// hits; those on surfaces look from what is seen in any case. Throws Cancelled.
[[nodiscard]] std::vector<Site> make_sites(const Solution& solution, const NodeOrder& order,
                                           const ClusterPoints& points, const RayTracer& tracer,
                                           const SitePlaces& places, const SiteReceivers& receivers,
                                           const ClassifySettings& settings, std::span<const float> thresholds,
                                           bool free_space, const Control& control, Statistics& statistics);

}  // namespace gg
