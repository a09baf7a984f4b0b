// Fixed points on senders, to which visibility rays go: the same for every receiver, so that neighbouring points of the
// picture see the same shadows. Every prefix of a sender's points is evenly spread.
#pragma once

#include <array>
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

inline constexpr std::uint32_t kMostPoints = 1024;  // of an element or lamp, that differ from one another

// The points of one cluster, field by field, so that many are worked on at once; or none.
class ClusterFaces {
  public:
    using Field = std::array<float, kClusterPoints>;

    [[nodiscard]] FacePoint operator[](std::uint32_t i) const {
        return {{x[i], y[i], z[i]}, {normal_x[i], normal_y[i], normal_z[i]}, {red[i], green[i], blue[i]}};
    }
    void set(std::uint32_t i, const FacePoint& point);
    [[nodiscard]] bool empty() const { return !(power(0) > 0); }
    // Luminance.
    [[nodiscard]] float power(std::uint32_t i) const { return luminance(Rgb(red[i], green[i], blue[i])); }
    [[nodiscard]] float power() const;  // of all

    Field x{}, y{}, z{}, normal_x{}, normal_y{}, normal_z{}, red{}, green{}, blue{};  // as of FacePoint
};

// Of all clusters: chosen by radiance times area; a parent's points are its children's.
class ClusterPoints {
  public:
    ClusterPoints() = default;
    ClusterPoints(const Solution& solution, const Control& control);

    // Empty for a dark cluster.
    [[nodiscard]] const ClusterFaces& of(NodeId cluster) const { return faces_[index_[cluster]]; }
    [[nodiscard]] std::size_t bytes() const { return faces_.capacity() * sizeof(ClusterFaces); }

  private:
    std::vector<std::uint32_t> index_;  // per node, into faces_, or kNone
    std::vector<ClusterFaces> faces_;
};

// Where a ray to a point of an element or lamp goes.
struct SenderPoint {
    Vec3 direction{0.0F};  // to be added to the origin at t = 1, or unit if the sender is infinitely far
    bool infinite = false;
    float weight = 0;  // what arrives from there: cosines over distance squared, any constant factor
};

// By which the square of the distance to a point of an element is larger than it is, as a share of the element's area.
inline constexpr float kSoftShare = 1e-3F;

// What is the same of a point for all receivers.
struct SenderPlace {
    float u = 0, v = 0;
    Vec3 target{0.0F};  // elements and flat lamps by area: the point; distant lamps: the direction to it
    float light = 0;    // luminance, W/m2: distant lamps: on a plane that faces it; elements: radiosity there
};

// The points of a sender as a receiver at x with unit normal n sees them. Keeps references.
class SenderSampler {
  public:
    SenderSampler(const Solution& solution, NodeId sender, Vec3 x, Vec3 n);

    [[nodiscard]] SenderPoint point(std::uint32_t index) const { return point(place(index)); }
    [[nodiscard]] SenderPlace place(std::uint32_t index) const;
    [[nodiscard]] SenderPoint point(const SenderPlace& place) const;
    // About the weight of a point that the receiver faces, and that faces it.
    [[nodiscard]] float facing_weight() const;
    // The first `count` indices, those of neighbouring points next to one another.
    std::span<const std::uint32_t> in_blocks(std::uint32_t count, std::vector<std::uint32_t>& order) const;

  private:
    const Solution& solution_;
    NodeId sender_;
    const Node& node_;
    const Lamp* lamp_ = nullptr;
    Vec3 x_, n_;
    Sequence4 places_;
    std::optional<LampSampler> sampler_;  // of a lamp
};

}  // namespace gg
