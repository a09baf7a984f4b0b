// Slow truth for the light in a whole scene: random walks, which know no elements, clusters or links.
#pragma once

#include <cstdint>

#include "core/vec.h"
#include "material/surface_color.h"
#include "radiosity/hierarchy.h"
#include "scene/scene.h"
#include "trace/ray_tracer.h"

namespace gg::oracle {

struct WalkedScene {
    const Scene& scene;
    const SurfaceColors& colors;
    const RayTracer& tracer;
};

// One estimate of the irradiance [W/m2] at a point with unit normal: lamps by one shadow ray each at every vertex of a
// walk of cosine-distributed steps, which ends by chance. Its mean over seeds is the truth.
[[nodiscard]] Vec3d walked_irradiance(const WalkedScene& scene, Vec3 position, Vec3 normal, std::uint64_t seed);

// Mean irradiance over all lit sides of a surface node's faces, W/m2, from that many walks.
[[nodiscard]] Vec3d mean_irradiance(const WalkedScene& scene, const Hierarchy& hierarchy, const Node& node,
                                    std::uint32_t walks);

}  // namespace gg::oracle
