// A visible point near a site.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "core/vec.h"
#include "film/fragments.h"
#include "radiosity/solution.h"

namespace gg {

struct Receiver {
    Vec3 position{0.0F};        // off its surface
    Vec3 normal{0.0F};          // unit, geometric, of the side that is seen
    Vec3 shading_normal{0.0F};  // unit, of that side
    NodeId place = kNone;
    float reflectance = 0;  // luminance, 0..1
    float irradiance = 0;   // by the radiosity solution, luminance, W/m2
    float pixel = 0;        // side of a pixel of the picture there, across the view direction, m

    [[nodiscard]] bool faces(Vec3 direction) const {
        return dot(normal, direction) > 0 && dot(shading_normal, direction) > 0;
    }
};

// What the radiosity solution says of a fragment, W/m2.
[[nodiscard]] inline Rgb irradiance_at(const Solution& solution, const Fragment& at) {
    return interpolated_irradiance(solution, at.hit.instance, at.hit.triangle, at.back, {at.hit.u, at.hit.v});
}

// Over a site's receivers.
struct ReceiverMeans {
    Vec3 position{0.0F};
    Vec3 normal{0.0F};                                     // of shading; unit, or zero where they cancel out
    float irradiance = 0, radiosity = 0, reflectance = 0;  // as of Receiver; radiosity: reflected
    float pixel = 0;
};

// receivers: at least one.
[[nodiscard]] inline ReceiverMeans means_of(std::span<const Receiver> receivers) {
    ReceiverMeans means;
    const float share = 1 / static_cast<float>(receivers.size());
    for (const Receiver& receiver : receivers) {
        means.position += share * receiver.position;
        means.normal += receiver.shading_normal;
        means.irradiance += share * receiver.irradiance;
        means.radiosity += share * receiver.reflectance * receiver.irradiance;
        means.reflectance += share * receiver.reflectance;
        means.pixel += share * receiver.pixel;
    }
    means.normal = normalize_or_zero(means.normal);
    return means;
}

// Receivers in turn, those that face a direction.
class ReceiverTurns {
  public:
    // The receivers must outlive this.
    explicit ReceiverTurns(std::span<const Receiver> receivers) : receivers_(receivers) {
        for (const Receiver& receiver : receivers) {
            if (std::none_of(kinds_.begin(), kinds_.end(), [&](const Receiver* kind) {
                    return kind->normal == receiver.normal && kind->shading_normal == receiver.shading_normal;
                })) {
                kinds_.push_back(&receiver);
            }
        }
    }

    // The next one that faces the direction, or null.
    [[nodiscard]] const Receiver* next(Vec3 direction) {
        // On a wall all are of one kind, and none faces what lies behind it.
        if (std::none_of(kinds_.begin(), kinds_.end(), [&](const Receiver* kind) { return kind->faces(direction); })) {
            return nullptr;
        }
        for (;;) {
            const Receiver& receiver = receivers_[next_++ % receivers_.size()];
            if (receiver.faces(direction)) {
                return &receiver;
            }
        }
    }

  private:
    std::span<const Receiver> receivers_;
    std::vector<const Receiver*> kinds_;  // one for every pair of normals
    std::size_t next_ = 0;
};

}  // namespace gg
