// Reflectance and emission where a camera ray met a surface, filtered over a sample's share of its pixel.
#pragma once

#include "core/vec.h"
#include "film/view.h"
#include "trace/ray_tracer.h"

namespace gg {

struct SampleColors {
    Rgb albedo{0.0F};    // 0..1
    Rgb emission{0.0F};  // radiance
};

// hit: of the ray; not missed. share: of its pixel that the sample stands for, 0..1.
[[nodiscard]] SampleColors colors_at(const View& view, const Ray& ray, const Hit& hit, float share);

}  // namespace gg
