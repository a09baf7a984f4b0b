// The points of a sender as many receivers see them: what SenderSampler says of one, in a fraction of the time.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/wide.h"
#include "gather/sender_points.h"

namespace gg {

// What receivers see of one point of a sender: rays to it, as of SenderPoint. Lanes beyond the last receiver mean
// nothing.
struct GroupPoint {
    std::vector<float> x, y, z;  // direction
    std::vector<float> weight;

    [[nodiscard]] Vec3 direction(std::size_t receiver) const { return {x[receiver], y[receiver], z[receiver]}; }
};

// For one thread; used again for sender after sender.
class SenderGroup {
  public:
    SenderGroup(const Solution& solution, const ClusterPoints& clusters) : solution_(solution), clusters_(clusters) {}

    // The next sender, without receivers.
    void begin(NodeId sender);
    // Unit normal n. looks: also for see(); those that do are the first ones.
    void add(Vec3 x, Vec3 n, bool looks = true);

    // At most so many points differ from one another.
    [[nodiscard]] std::uint32_t most_points() const;
    [[nodiscard]] bool infinite() const;  // as of SenderPoint
    // About the weight of a point that the receiver at x faces, and that faces it; 0 of a dark cluster.
    [[nodiscard]] float facing_weight(Vec3 x) const;
    // Of each receiver: unoccluded_irradiance().
    void light(std::vector<Rgb>& out) const;
    // What the first `receivers` of those that look see of a point; without a number, all of these.
    void see(std::uint32_t index, std::size_t receivers, GroupPoint& out) const;
    void see(std::uint32_t index, GroupPoint& out) const { see(index, looking_, out); }
    // The first `count` indices, those of neighbouring points next to one another.
    std::span<const std::uint32_t> in_blocks(std::uint32_t count, std::vector<std::uint32_t>& order) const;

  private:
    // Receivers, a lane each.
    struct Block {
        WideVec3 x, n;
        Wide by_angle = 0;  // 1: sees a rectangle by its solid angle
        RectangleView<Wide> rectangle;
        BilinearWarpOf<Wide> warp;
        SphereViewOf<Wide> sphere;
    };
    struct Seen {
        WideVec3 direction;
        Wide weight = 0;
    };
    struct Lit {
        WideVec3 light;                     // W/m2
        WideMask clipped = WideMask(true);  // lanes that are to be looked at one by one
    };
    // A point that is the same for all, and shines to one side.
    struct Target {
        Vec3 position{0.0F}, normal{0.0F};
        float strength = 0;              // luminance, up to a factor
        float soft = 0, soft_again = 0;  // m2 by which either factor of the distance's square is larger
    };

    [[nodiscard]] Lit light_of_element(const Block& block) const;
    [[nodiscard]] Lit light_of_rectangle(const Block& block) const;
    [[nodiscard]] bool has_targets() const;
    [[nodiscard]] Target target(std::uint32_t index) const;
    [[nodiscard]] static Seen see(const Target& target, const Block& block);
    [[nodiscard]] Seen see_rectangle(Vec2 place, const Block& block) const;
    [[nodiscard]] Seen see_sphere(Vec2 disk, const Block& block) const;
    [[nodiscard]] Seen see_point(const Block& block) const;
    [[nodiscard]] static Seen see_distant(const SenderPlace& place, const Block& block);

    const Solution& solution_;
    const ClusterPoints& clusters_;
    NodeId sender_ = kNone;
    const Lamp* lamp_ = nullptr;
    std::optional<SenderSampler> sampler_;             // of the first receiver; none of a cluster
    Vec3 axis_x_{0.0F}, axis_y_{0.0F}, axis_z_{0.0F};  // of a rectangle that is seen by its solid angle
    std::vector<Block> blocks_;
    std::size_t count_ = 0;     // of receivers
    std::size_t looking_ = 0;   // of them, the first ones
    std::size_t by_angle_ = 0;  // of these
};

}  // namespace gg
