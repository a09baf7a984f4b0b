// Surfaces divided to a size that is wanted.
#pragma once

#include <vector>

#include "radiosity/surface_mesh.h"
#include "support/test_scenes.h"

namespace gg::test {

// A floor of 4 x 4 m (instance 0) below a small lamp.
[[nodiscard]] SceneDescription lit_floor();

// Triangles have this side, m, wherever they are.
[[nodiscard]] SurfaceMesh::LengthOf even(float side);

// Evenly over all triangles of an instance, two spots in each of size x size cells.
[[nodiscard]] std::vector<SurfaceSpot> raster(const Scene& scene, std::uint32_t instance, int size);

// As far as these spots show it.
[[nodiscard]] SurfaceMesh divided(const Solution& solution, const SurfaceMesh::Settings& settings,
                                  const std::vector<SurfaceSpot>& spots);

[[nodiscard]] Vec3 position_of(const Scene& scene, const SurfaceSpot& spot);

}  // namespace gg::test
