// What rays see of the light that is known so far.
#pragma once

#include "radiosity/instance_parts.h"
#include "radiosity/lighting.h"
#include "trace/ray_tracer.h"

namespace gg {

class SeenLight {
  public:
    // Both must outlive this; elements may be opened, clusters not.
    SeenLight(const Hierarchy& hierarchy, const Lighting& lighting);

    // Radiosity of what the ray hit, W/m2: of the undivided element, or the mean over the leaf cluster. pi times the
    // world's radiance if it missed.
    [[nodiscard]] Rgb radiosity(const Ray& ray, const Hit& hit) const;

  private:
    const Hierarchy* hierarchy_;
    const Lighting* lighting_;
    ElementTable elements_;
    ClusterTable clusters_;
};

}  // namespace gg
