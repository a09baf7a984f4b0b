// Which parts of the sky a site sees: settled where all around it agree, else cells small enough for one ray each.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"
#include "gather/direction_table.h"
#include "gather/receiver.h"
#include "gather/surroundings.h"
#include "trace/ray_tracer.h"

namespace gg {

// A cell of the sky that some points around a site see. Looked at anew by one ray, in a direction of its own.
struct SkyLeaf {
    std::uint32_t id = 0;   // the same for the same cell
    Vec3 direction{0.0F};   // unit
    float solid_angle = 0;  // sr
};

// For one thread.
class SkyLeaves {
  public:
    SkyLeaves(const RayTracer& tracer, Rgb radiance);

    // around: what the receivers saw. size: solid angle that one leaf may have, sr. Leaves come in ascending order;
    // what is settled is added to the table.
    void find(std::span<const Receiver> receivers, const Surroundings& around, float size, std::vector<SkyLeaf>& leaves,
              DirectionTable& table);
    [[nodiscard]] std::size_t ray_count() const { return ray_count_; }  // so far

  private:
    // Rays into parts of cells, from receivers that face them.
    struct Look {
        std::uint32_t rays = 0, misses = 0;
    };
    enum class State : std::uint8_t { kUnknown, kHidden, kSeen, kMixed };
    [[nodiscard]] static State state_of(const Look& look);
    void settle(std::uint8_t level, DirectionTable& table);
    void look_into(std::span<const SkyCell> cells, std::uint32_t count, std::span<const Receiver> receivers);

    const RayTracer& tracer_;
    Rgb radiance_;
    std::vector<SkyCell> cells_, finer_;
    std::vector<Look> looks_;            // per cell
    std::vector<State> states_;          // per cell
    std::vector<std::uint32_t> places_;  // of cells in the picture of a level
    std::vector<Ray> rays_;
    std::vector<std::uint32_t> owners_;  // per ray
    std::vector<std::uint8_t> blocked_;
    std::size_t ray_count_ = 0;
};

}  // namespace gg
