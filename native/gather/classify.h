// Which senders may be interpolated around a site [Scheel et al. 2002, section 4.3].
#pragma once

#include <span>
#include <vector>

#include "gather/closer_look.h"
#include "gather/gather_counts.h"
#include "gather/node_order.h"
#include "gather/receiver.h"
#include "gather/sender_cut.h"
#include "gather/sender_measure.h"
#include "gather/sender_points.h"
#include "gather/shadow_samples.h"
#include "gather/site.h"
#include "gather/sky_leaves.h"
#include "gather/surroundings.h"
#include "transport/emitter_sampling.h"

namespace gg {

struct ClassifySettings {
    int samples = 512;         // visibility rays of a point, N of eq. 1, where it is as bright as the mean
    float threshold = 0.03F;   // error that one sender may have, as a share of the local radiosity
    float mean_radiosity = 0;  // of what is seen, W/m2; 0: unknown
    float sky_leaf = 0.015F;   // irradiance of a part of the sky that has one ray, as a share of all
    float reach = 1;           // of surfaces that are too close to interpolate, in diameters of the site
};

// Error that one sender may have where surfaces have that mean radiosity, W/m2.
[[nodiscard]] float threshold_at(const ClassifySettings& settings, float radiosity);

// Makes sites, one after the other; for one thread.
class Classifier {
  public:
    Classifier(const Solution& solution, const NodeOrder& order, const ClusterPoints& points, const RayTracer& tracer,
               const ClassifySettings& settings);

    // receivers: at least one. threshold: error of radiosity that one sender may have where somebody looks [W/m2]; 0:
    // nobody does, and the settings tell the threshold and the samples.
    [[nodiscard]] Site classify(std::span<const Receiver> receivers, float threshold = 0);
    [[nodiscard]] const GatherCounts& counts() const { return counts_; }

  private:
    struct Candidate {
        CutSender cut;
        SenderMeasure brings;
        float spread_bound = 0;  // of the irradiance vector where receivers are too few to tell, W/m2
        float bound = 0;         // W/m2 that it may bring to any point around
        bool matters = false;    // somewhere around
        std::uint32_t first_ray = 0, ray_count = 0;
        float visibility = 0;                               // 0..1
        float form_factor_error = 0, visibility_error = 0;  // W/m2
        bool resample_form_factor = false, resample_visibility = false;
        bool mixed = false;  // some of its rays arrive
    };

    // Where a site is, and what it asks for.
    struct Place {
        Box bounds;
        ReceiverMeans means;
        bool looked_at = false;
        float threshold = 0, tolerance = 0;  // of radiosity and of irradiance, W/m2
        float samples = 0;                   // N of eq. 1
        float all = 0;                       // irradiance of all candidates, at least that of the place, W/m2

        [[nodiscard]] float samples_of(const SenderMeasure& brings) const {  // eq. 1
            return samples * luminance(brings.irradiance) / all;
        }
    };

    [[nodiscard]] Place place_of(std::span<const Receiver> receivers, float threshold) const;
    void find_candidates(Place& place);
    void look_at_candidates(std::span<const Receiver> receivers, const Place& place);
    void settle_candidates(const Place& place, Site& site);
    void add_rays(Candidate& candidate, std::span<const Receiver> receivers, std::uint32_t count);
    void judge(Candidate& candidate, float irradiance, float tolerance);
    [[nodiscard]] float occluder_of(const Candidate& candidate) const;
    void keep_to_budget(float tolerance);

    const Solution& solution_;
    const NodeOrder& order_;
    const ClusterPoints& points_;
    const RayTracer& tracer_;
    ClassifySettings settings_;
    CutBuilder cutter_;
    SenderMeter meter_;
    Surroundings surroundings_;
    SkyLeaves sky_;
    SenderCut cut_;
    std::vector<NodeId> places_;
    std::vector<Candidate> candidates_;
    std::vector<LeftSender> left_;
    std::vector<float> errors_;     // that are left to interpolation
    std::vector<bool*> resampled_;  // whether each shall not be
    std::vector<Ray> rays_;
    std::vector<std::uint8_t> blocked_;
    GatherCounts counts_;
};

}  // namespace gg
