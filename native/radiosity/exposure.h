// Which faces of a mesh have room above them.
#pragma once

#include <cstdint>
#include <vector>

#include "radiosity/faces.h"

namespace gg {

// By rays from the faces of one placed instance, which stands for all instances of its mesh; only its own faces are in
// their way. `tree` holds all its triangles; those of a leaf that lie alike share their rays.
[[nodiscard]] std::vector<Exposure> find_exposure(const Scene& scene, std::uint32_t instance, const ClusterTree& tree,
                                                  const RayTracer& tracer, const Control& control);

}  // namespace gg
