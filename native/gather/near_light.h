// Light of clusters that are too close to be one thing: found by rays in fixed directions that count what they hit.
#pragma once

#include <span>
#include <vector>

#include "core/vec.h"
#include "radiosity/solution.h"
#include "trace/ray_tracer.h"

namespace gg {

inline constexpr std::uint32_t kNearDirections = 128;  // of a hemisphere

// Points that look around together.
struct NearOrigin {
    Vec3 position{0.0F};  // off its surface
    Vec3 normal{0.0F};    // unit
};

// For one thread.
class NearLight {
  public:
    NearLight(const Solution& solution, const RayTracer& tracer);

    // body(unit direction, irradiance [W/m2] of a plane that faces it) for every direction in which faces of `clusters`
    // are met. Each direction is looked into from one of the points that have it above them, in turn: a point alone has
    // half of all directions.
    template <typename Body>
    void for_each_hit(std::span<const NodeId> clusters, std::span<const NearOrigin> origins, const Body& body) {
        trace(origins);
        for_each_hit_again(clusters, body);
    }
    // The same rays, other clusters.
    template <typename Body>
    void for_each_hit_again(std::span<const NodeId> clusters, const Body& body) {
        mark(clusters);
        for (const Found& found : found_) {
            if (is_marked(found.place)) {
                body(found.direction, found.irradiance);
            }
        }
    }
    void trace(std::span<const NearOrigin> origins);

  private:
    struct Found {
        Vec3 direction{0.0F};
        Rgb irradiance{0.0F};
        NodeId place = kNone;
    };
    void mark(std::span<const NodeId> clusters);
    [[nodiscard]] bool is_marked(NodeId place) const;

    const Solution& solution_;
    const RayTracer& tracer_;
    std::vector<Vec3> directions_;  // of the whole sphere
    std::vector<std::uint32_t> marks_;
    std::uint32_t stamp_ = 0;
    std::vector<Ray> rays_;
    std::vector<Hit> hits_;
    std::vector<Found> found_;
};

}  // namespace gg
