// Light at a point as a blend of the models of sites around it: continuous, for each model is and the weights are
// [Scheel et al. 2002, section 4.4].
#pragma once

#include <array>
#include <span>
#include <vector>

#include "film/fragments.h"
#include "gather/gather_counts.h"
#include "gather/sender_group.h"
#include "gather/shared_light.h"
#include "gather/site.h"
#include "gather/site_places.h"
#include "gather/surroundings.h"
#include "trace/ray_tracer.h"

namespace gg {

struct WeightedSite {
    const Site* site = nullptr;
    float weight = 0;  // 0..1, of all at a point they sum to 1
};

// A fragment and the sites around it.
struct PlacedFragment {
    Fragment at;
    std::array<WeightedSite, SitePlace::kMost> around;
    std::uint32_t count = 0;  // of sites
    float on_surface = 0;     // weight of those on the fragment's surface
    KnownLight known = {};
    std::uint32_t part = 0;  // of fragments whose mean counts: which, for each sees other points

    [[nodiscard]] std::span<const WeightedSite> sites() const { return std::span(around).first(count); }
};

// Shades points, several at a time: where they lie together, so do their rays. For one thread.
class Shader {
  public:
    Shader(const Solution& solution, const NodeOrder& order, const ClusterPoints& points, const RayTracer& tracer);

    // light, taken: of each; what it took.
    void shade(std::span<const PlacedFragment> fragments, std::span<PointLight> light, std::span<PointCounts> taken);
    [[nodiscard]] const GatherCounts& counts() const { return counts_; }

    // Of the last call: to senders and the sky, and to what is near.
    [[nodiscard]] std::span<const Ray> visibility_rays() const { return rays_; }
    [[nodiscard]] std::span<const Ray> near_rays() const { return surroundings_.rays(); }

  private:
    // A sender of any of a point's sites.
    struct Task {
        NodeId sender = kNone;
        bool form_factor = false, visibility = false, soft = false;
        float samples = 0;
        Rgb unoccluded{0.0F};
        float expected = 0;        // visibility by the sites that resample it
        float bright = 0;          // about what it brings unoccluded, luminance, W/m2
        float sent = 0, seen = 0;  // weights of all rays, and of those that arrive
        bool known = false;        // `expected` is its visibility

        [[nodiscard]] float visible() const { return known ? expected : sent > 0 ? seen / sent : 0; }
    };

    struct Point {
        Vec3 x{0.0F};  // where its rays start
        float share_of_samples = 1;
        std::uint32_t first_task = 0, end_task = 0;
        PointLight light;
        PointCounts taken;
    };

    struct RayOwner {
        std::uint32_t point = 0, task = 0;  // no task: of the sky's rays
        float weight = 0;
    };

    // A point that looks at the sender of the moment.
    struct Member {
        std::uint32_t point = 0, task = 0;
        std::uint32_t first = 0;        // of the sender's points that it sees
        std::uint32_t whole = 0;        // samples of its visibility
        float of_all = 0, of_last = 0;  // share of a sample, and of one after the last whole one

        [[nodiscard]] std::uint32_t count() const { return whole + (of_last > 0 ? 1 : 0); }
        [[nodiscard]] std::uint32_t end() const { return first + count(); }
    };

    void plan(const PlacedFragment& fragment);
    void add_ray(RayOwner owner, Vec3 direction, float far);
    void add_sky_rays(std::span<const PlacedFragment> fragments);
    void look_at_senders(std::span<const PlacedFragment> fragments);
    void plan_samples(std::span<const PlacedFragment> fragments);
    void work_out_form_factors();
    void add_rays(std::span<const PlacedFragment> fragments);
    void trace();
    [[nodiscard]] PointLight light_of_models(const PlacedFragment& fragment, const Point& point,
                                             const TableCosines& cosines) const;
    void add_near_light(std::span<const PlacedFragment> fragments);

    const Solution& solution_;
    const RayTracer& tracer_;
    Surroundings surroundings_;
    std::vector<Point> points_;
    std::vector<TableCosines> cosines_;  // per point
    std::vector<NearPoint> near_;        // per point
    std::vector<Task> tasks_;            // point by point, by sender in ascending order
    std::vector<Ray> rays_;              // first those to the sky
    std::vector<RayOwner> owners_;       // per ray
    std::size_t sky_rays_ = 0;
    std::vector<Member> members_;
    SenderGroup group_;                 // the members as receivers
    GroupPoint seen_;                   // what they see
    std::vector<Rgb> unoccluded_;       // irradiance, per member
    std::vector<std::uint32_t> next_;   // in lists that are merged
    std::vector<std::uint32_t> heads_;  // keys that they have there
    std::vector<std::uint32_t> order_;
    std::vector<std::uint8_t> blocked_;
    GatherCounts counts_;
};

}  // namespace gg
