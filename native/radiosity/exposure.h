// Which faces of a mesh have room above them.
#pragma once

#include <cstdint>
#include <vector>

#include "radiosity/faces.h"

namespace gg {

// By short rays from the faces of one placed instance, which stands for all instances of its mesh.
[[nodiscard]] std::vector<Exposure> find_exposure(const Scene& scene, std::uint32_t instance, const RayTracer& tracer,
                                                  const Control& control);

}  // namespace gg
