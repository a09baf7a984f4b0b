// Fixed points on senders, to which visibility rays go: the same for every receiver, so that neighbouring points of the
// picture see the same shadows. Every prefix of a sender's points is evenly spread.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/random.h"
#include "radiosity/solution.h"
#include "transport/emitter_sampling.h"

namespace gg {

class Control;

// A point of a cluster's faces.
struct FacePoint {
    Vec3 position{0.0F};
    Vec3 normal{0.0F};  // unit, of the side that shines
    Rgb power{0.0F};    // W/sr: radiance times area that it stands for, if all kClusterPoints are taken
};
inline constexpr std::uint32_t kClusterPoints = 32;

// Of all clusters: chosen by radiance times area; a parent's points are its children's.
class ClusterPoints {
  public:
    ClusterPoints() = default;
    ClusterPoints(const Solution& solution, const Control& control);

    // Empty for a dark cluster; else kClusterPoints.
    [[nodiscard]] std::span<const FacePoint> of(NodeId cluster) const;
    [[nodiscard]] std::size_t bytes() const { return points_.capacity() * sizeof(FacePoint); }

  private:
    std::vector<std::uint32_t> first_;  // per node, into points_, or kNone
    std::vector<FacePoint> points_;
};

// Where a ray to a point of an element or lamp goes.
struct SenderPoint {
    Vec3 direction{0.0F};  // to be added to the origin at t = 1, or unit if the sender is infinitely far
    bool infinite = false;
    float weight = 0;  // what arrives from there: cosines over distance squared, any constant factor
};

// What is the same of a point for all receivers.
struct SenderPlace {
    float u = 0, v = 0;
    Vec3 target{0.0F};  // elements: the point; distant lamps: the direction to it
    float light = 0;    // distant lamps: luminance on a plane that faces it
};

// The points of a sender as a receiver at x with unit normal n sees them. Keeps references.
class SenderSampler {
  public:
    SenderSampler(const Solution& solution, NodeId sender, Vec3 x, Vec3 n);
    // Of the same sender for another receiver.
    SenderSampler(const SenderSampler& like, Vec3 x, Vec3 n);

    [[nodiscard]] SenderPoint point(std::uint32_t index) const { return point(place(index)); }
    [[nodiscard]] SenderPlace place(std::uint32_t index) const;
    [[nodiscard]] SenderPoint point(const SenderPlace& place) const;
    // About the weight of a point that the receiver faces, and that faces it.
    [[nodiscard]] float facing_weight() const;
    // The first `count` indices, those of neighbouring points next to one another.
    std::span<const std::uint32_t> in_blocks(std::uint32_t count, std::vector<std::uint32_t>& order) const;

  private:
    const Node& node_;
    const Lamp* lamp_ = nullptr;
    Vec3 x_, n_;
    Sequence4 places_;
    std::optional<LampSampler> sampler_;  // of a lamp
};

}  // namespace gg
