// Sites as published: from points in free space around a grid vertex, with counted hits, and an error bound for each
// sender by itself [Scheel et al. 2002, section 4.3 and figure 2]. Only the sky, which the paper does not have, and the
// disjoint cut are ours.
#pragma once

#include <span>
#include <vector>

#include "gather/classify.h"

namespace gg {

// Which of the rays end on the way to a sender: rays from free space may pass one object, since the receiver lies
// somewhere along them. An object is one face that is lit from both sides, or two that are lit from one.
class HitCounter {
  public:
    HitCounter(const Scene& scene, const RayTracer& tracer) : scene_(scene), tracer_(tracer) {}

    // blocked: per ray.
    void count(std::span<const Ray> rays, std::vector<std::uint8_t>& blocked);

  private:
    const Scene& scene_;
    const RayTracer& tracer_;
    std::vector<Ray> rest_;            // of rays that may go on
    std::vector<std::uint32_t> rays_;  // whose rest it is
    std::vector<Hit> hits_;
    std::vector<int> faces_;  // per ray: met so far, those with both sides twice
};

// What surrounds a grid vertex.
struct FreeSpace {
    Vec3 vertex{0.0F};
    std::vector<Vec3> points;             // in the cells around it
    std::span<const Receiver> receivers;  // what is seen there: links, reflectance and the local radiosity are theirs
};

// For one thread.
class FreeSpaceClassifier {
  public:
    static constexpr std::uint32_t kMostPoints = 64;

    // settings: samples, threshold, mean radiosity and the sky's leaves count.
    FreeSpaceClassifier(const Solution& solution, const NodeOrder& order, const ClusterPoints& points,
                        const RayTracer& tracer, const ClassifySettings& settings);

    // At least two points and one receiver. threshold: as for Classifier.
    [[nodiscard]] Site classify(const FreeSpace& space, float threshold = 0);
    [[nodiscard]] const GatherCounts& counts() const { return counts_; }

  private:
    struct Candidate {
        NodeId sender = kNone;
        float occluder = 0;         // as of CutSender
        float importance = 0;       // share of all unoccluded irradiance [eq. 1]
        float least = 0, most = 0;  // unoccluded irradiance over the points, luminance, W/m2
        Rgb irradiance{0.0F};       // mean, of a plane that faces the mean direction
        Vec3 direction{0.0F};
        std::uint32_t first_ray = 0, ray_count = 0;
    };

    void list_candidates(const FreeSpace& space);
    void sample(Candidate& candidate, std::span<const Vec3> points);
    void add_self_links(Vec3 vertex, DirectionTable& table);

    const Solution& solution_;
    const NodeOrder& order_;
    const ClusterPoints& cluster_points_;
    ClassifySettings settings_;
    CutBuilder cutter_;
    Surroundings surroundings_;
    SkyLeaves sky_;
    HitCounter hit_counter_;
    SenderCut cut_;
    std::vector<NodeId> places_;
    std::vector<Candidate> candidates_;
    std::vector<Ray> rays_;
    std::vector<std::uint8_t> blocked_;
    std::vector<RankRange> self_, linked_;
    GatherCounts counts_;
};

}  // namespace gg
