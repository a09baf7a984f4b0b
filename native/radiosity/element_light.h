// What several points of an element see of the light that is known so far.
#pragma once

#include <array>

#include "radiosity/seen_light.h"

namespace gg {

// For one thread.
class ElementLight {
  public:
    static constexpr int kPoints = 6;
    using Points = std::array<Vec3, kPoints>;
    using Values = std::array<float, kPoints>;

    ElementLight(const SeenLight& seen, const RayTracer& tracer) : seen_(seen), tracer_(tracer) {}

    // The corners 0..2, and the middles 3..5 of the edges opposite, each a little towards the centre.
    [[nodiscard]] static Points points_of(const Node& element);

    // Luminance of the irradiance, W/m2. All points look into the same directions: what differs between them is then
    // more than noise.
    [[nodiscard]] Values at(const Points& points, const Node& element);

  private:
    static constexpr int kDirections = 8;

    const SeenLight& seen_;
    const RayTracer& tracer_;
    std::array<Ray, kPoints * kDirections> rays_;
    std::array<Hit, kPoints * kDirections> hits_;
};

}  // namespace gg
