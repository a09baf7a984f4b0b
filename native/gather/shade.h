// Light at a point as a blend of the models of sites around it: continuous, for each model is and the weights are
// [Scheel et al. 2002, section 4.4].
#pragma once

#include <array>
#include <span>
#include <vector>

#include "film/fragments.h"
#include "gather/gather_counts.h"
#include "gather/near_light.h"
#include "gather/sender_points.h"
#include "gather/site.h"
#include "trace/ray_tracer.h"

namespace gg {

struct WeightedSite {
    const Site* site = nullptr;
    float weight = 0;  // 0..1, of all at a point they sum to 1
};

// Shades points, one after the other; for one thread.
class Shader {
  public:
    Shader(const Solution& solution, const ClusterPoints& points, const RayTracer& tracer);

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

    void plan(std::span<const WeightedSite> sites);
    void add_rays(const Fragment& at, Vec3 x, Task& task);
    void weigh(Task& task) const;

    const Solution& solution_;
    const ClusterPoints& points_;
    const RayTracer& tracer_;
    NearLight near_;
    std::vector<Task> tasks_;
    std::vector<Ray> rays_;
    std::vector<float> weights_;
    std::vector<std::uint8_t> blocked_;
    GatherCounts counts_;
};

}  // namespace gg
