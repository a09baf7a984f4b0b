// What senders would bring to the receivers of a site if nothing were in the way.
#pragma once

#include <span>
#include <vector>

#include "core/wide.h"
#include "gather/receiver.h"
#include "gather/sender_points.h"
#include "radiosity/solution.h"

namespace gg {

// Of one sender, over the receivers that it may light; all zero if there are none.
struct SenderMeasure {
    Rgb irradiance{0.0F};  // W/m2, mean, of a plane that faces the mean direction
    Vec3 direction{0.0F, 0.0F, 1.0F};
    float spread = 0;      // of the irradiance vector, W/m2
    float largest = 0;     // W/m2
    bool horizon = false;  // part of the sender lies below the horizon of some receiver
};

// For one thread. Keeps references.
class SenderMeter {
  public:
    SenderMeter(const Solution& solution, const ClusterPoints& points) : solution_(solution), points_(points) {}

    // The receivers to come; they must outlive their use.
    void look_from(std::span<const Receiver> receivers);
    // Over `count` receivers if so many see the sender, and a few more where that costs nothing. Not for the sky.
    [[nodiscard]] SenderMeasure measure(NodeId sender, std::size_t count);
    // Luminance of the irradiance that a sender may bring to any point of a box, W/m2; of lamps infinity.
    [[nodiscard]] float bound(NodeId sender, const Box& box) const;

  private:
    // Receivers, a lane each; those beyond the last one face nothing.
    struct Block {
        WideVec3 position, normal;
    };

    // Vector form factors; zero where the receiver is behind the sender.
    [[nodiscard]] WideVec3 vectors_of_element(const Block& block) const;
    [[nodiscard]] static WideVec3 vectors_of_rectangle(const Lamp& lamp, const Block& block);
    void add_in_blocks(std::size_t count);
    void add_one_by_one(std::size_t count);
    void add(Vec3 vector, bool crosses_horizon);

    const Solution& solution_;
    const ClusterPoints& points_;
    std::span<const Receiver> receivers_;
    std::vector<Block> blocks_;  // of the first receivers
    NodeId sender_ = kNone;
    SenderMeasure sum_;
    std::vector<Vec3> vectors_;  // irradiance, luminance, along the direction that it comes from
};

}  // namespace gg
