// Light on the faces that stayed in clusters: links know only the cluster as a whole.
#pragma once

#include <cstdint>
#include <vector>

#include "core/vec.h"
#include "radiosity/faces.h"

namespace gg {

class Control;
class Lighting;
class RayTracer;
struct Solution;

class FaceLight {
  public:
    // Mean irradiance of the group that a side of a triangle belongs to, W/m2; the triangle must be in a cluster.
    [[nodiscard]] Rgb irradiance(const SceneFaces& faces, const Scene& scene, std::uint32_t instance,
                                 std::uint32_t triangle, bool back) const {
        const FaceGroups& groups = faces.meshes[scene.instances[instance].mesh].groups;
        return irradiance_[first_[instance] + groups.of(triangle, back)];
    }
    [[nodiscard]] std::size_t count() const { return irradiance_.size(); }
    [[nodiscard]] std::size_t bytes() const;

  private:
    friend class FaceGatherer;
    std::vector<std::uint32_t> first_;  // instance -> its first group in irradiance_
    std::vector<Rgb> irradiance_;
};

// Gathers over the hemisphere of every group of faces: `rays` rays bring the radiosity of what they hit, as the
// converged links left it, shadow rays the light of lamps. Light between such faces goes to and fro a few times.
// Solution::vertices must know the elements.
[[nodiscard]] FaceLight gather_face_light(const Solution& solution, const RayTracer& tracer, int rays,
                                          const Control& control);

}  // namespace gg
