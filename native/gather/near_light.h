// Light of clusters that are too close to be one thing: found by rays in fixed directions that count what they hit.
#pragma once

#include <span>
#include <vector>

#include "core/vec.h"
#include "radiosity/solution.h"
#include "trace/ray_tracer.h"

namespace gg {

inline constexpr std::uint32_t kNearDirections = 128;  // of a hemisphere

// For one thread.
class NearLight {
  public:
    NearLight(const Solution& solution, const RayTracer& tracer);

    // Irradiance [W/m2] at x, already off its surface, on unit normal n, from faces in `clusters`.
    [[nodiscard]] Rgb irradiance(std::span<const NodeId> clusters, Vec3 x, Vec3 n);

    // body(unit direction, radiosity of what is hit) for every ray above n that meets faces in `clusters`; a ray stands
    // for a share 1 / kNearDirections of 2 pi sr.
    template <typename Body>
    void for_each_hit(std::span<const NodeId> clusters, Vec3 x, Vec3 n, const Body& body) {
        trace(clusters, x, n);
        for (const Found& found : found_) {
            body(found.direction, found.radiosity);
        }
    }

  private:
    struct Found {
        Vec3 direction{0.0F};
        Rgb radiosity{0.0F};
    };
    void trace(std::span<const NodeId> clusters, Vec3 x, Vec3 n);

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
