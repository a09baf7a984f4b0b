// The classical final gather: at every point every sender is looked at anew. Slow, and what the fast one is held
// against.
#pragma once

#include <vector>

#include "film/fragments.h"
#include "gather/gather_counts.h"
#include "gather/node_order.h"
#include "gather/sender_cut.h"
#include "gather/sender_points.h"
#include "gather/sky_leaves.h"
#include "gather/surroundings.h"

namespace gg {

// Gathers at points, one after the other; for one thread.
class FullGather {
  public:
    // samples: visibility rays from a point, about.
    FullGather(const Solution& solution, const NodeOrder& order, const ClusterPoints& points, const RayTracer& tracer,
               int samples);

    // Irradiance, W/m2. `expected` [W/m2]: about as much, luminance.
    [[nodiscard]] Rgb irradiance(const Fragment& at, float expected);

    [[nodiscard]] const GatherCounts& counts() const { return counts_; }

  private:
    struct Task {
        std::size_t sender = 0;  // of cut_
        Rgb light{0.0F};         // of an element, lamp or cell: unoccluded; of a cluster: per ray in ray_light_
        std::uint32_t first_ray = 0, ray_count = 0;
    };

    void plan(const Fragment& at);
    [[nodiscard]] Rgb light_of_tasks() const;
    [[nodiscard]] Rgb light_from_all_around(const Fragment& at, Vec3 x);
    void add_rays(const Fragment& at, Task& task, std::uint32_t count);

    const Solution& solution_;
    const NodeOrder& order_;
    const ClusterPoints& points_;
    const RayTracer& tracer_;
    int samples_;
    float expected_ = 0;  // irradiance at the point, about, luminance, W/m2
    CutBuilder cutter_;
    Surroundings surroundings_;
    SkyLeaves sky_;
    SenderCut cut_;
    std::vector<Task> tasks_;
    std::vector<Ray> rays_;
    std::vector<float> weights_;  // per ray
    std::vector<Rgb> ray_light_;  // per ray of clusters
    std::vector<std::uint8_t> blocked_;
    std::vector<RankRange> apart_;  // surfaces among the tasks
    std::vector<SkyLeaf> leaves_;
    GatherCounts counts_;
};

}  // namespace gg
