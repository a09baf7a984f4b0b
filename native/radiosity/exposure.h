// Which faces of a mesh have room above them.
#pragma once

#include <cstdint>
#include <vector>

#include "radiosity/faces.h"

namespace gg {

// By rays from the groups of faces of one placed instance, which stands for all instances of its mesh; only its own
// faces are in their way. Groups are split into what is covered from close by and what is not.
// scene_size: as group_faces.
[[nodiscard]] std::vector<Exposure> find_exposure(const Scene& scene, std::uint32_t instance, FaceGroups& groups,
                                                  float scene_size, const RayTracer& tracer, const Control& control);

}  // namespace gg
