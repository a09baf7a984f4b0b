// Light at a point as a blend of the models of sites around it: continuous, for each model is and the weights are
// [Scheel et al. 2002, section 4.4].
#pragma once

#include <array>
#include <span>
#include <vector>

#include "film/fragments.h"
#include "gather/gather_counts.h"
#include "gather/sender_points.h"
#include "gather/site.h"
#include "gather/surroundings.h"
#include "trace/ray_tracer.h"

namespace gg {

struct WeightedSite {
    const Site* site = nullptr;
    float weight = 0;  // 0..1, of all at a point they sum to 1
};

// Shades points, one after the other; for one thread.
class Shader {
  public:
    Shader(const Solution& solution, const NodeOrder& order, const ClusterPoints& points, const RayTracer& tracer);

    // Irradiance, W/m2.
    [[nodiscard]] Rgb irradiance(const Fragment& at, std::span<const WeightedSite> sites);
    [[nodiscard]] const GatherCounts& counts() const { return counts_; }

  private:
    // A sender of any of the sites.
    struct Task {
        NodeId sender = kNone;
        bool form_factor = false, visibility = false;
        float samples = 0;
        Rgb unoccluded{0.0F};
        std::uint32_t first_ray = 0, ray_count = 0;
        float seen = 1;  // visibility at the point
    };

    // A part of the sky that any of the sites looks at anew.
    struct SkyTask {
        Vec3 direction{0.0F};
        float weight = 0;  // solid angle times the sites' weights, sr
    };

    void plan(std::span<const WeightedSite> sites);
    void plan_sky(const Fragment& at, Vec3 x, std::span<const WeightedSite> sites);
    [[nodiscard]] Rgb near_light(std::span<const WeightedSite> sites, const TableCosines& cosines) const;
    void add_rays(const Fragment& at, Vec3 x, Task& task);
    void weigh(Task& task) const;

    const Solution& solution_;
    const ClusterPoints& points_;
    const RayTracer& tracer_;
    Surroundings surroundings_;
    std::vector<Task> tasks_;
    std::vector<SkyTask> sky_tasks_;
    std::vector<Ray> rays_;
    std::vector<float> weights_;
    std::vector<std::uint32_t> order_;
    std::vector<std::uint8_t> blocked_;
    GatherCounts counts_;
};

}  // namespace gg
