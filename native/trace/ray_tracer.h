// Rays against the triangles of a scene. The only part that knows Embree (3.13 or 4.x).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "core/vec.h"
#include "scene/scene.h"

namespace gg {

class Control;

// Points origin + t * direction with t in [near, far]; t counts lengths of `direction`, which need not be unit.
struct Ray {
    Vec3 origin{0.0F};
    Vec3 direction{0.0F};
    float near = 0;
    float far = kInfinity;
};

struct Hit {
    std::uint32_t instance = kNone;  // into Scene::instances; kNone: nothing was hit, the rest means nothing
    std::uint32_t triangle = kNone;  // into Mesh::triangles
    float u = 0, v = 0;              // barycentric weights of corners 1 and 2
    float distance = kInfinity;      // the ray's t

    [[nodiscard]] bool missed() const { return instance == kNone; }
};

// Which instances a ray sees: all but those hidden from the camera, or all but those hidden from light.
enum class RayMask : std::uint32_t { kCamera = 1, kLight = 2 };

// How the rays of one call relate: neighbours with a common origin or target, or anything.
enum class Coherence { kIncoherent, kCoherent };

// Queries are const and may run on any number of threads at once. Both sides of every triangle stop rays. A ray that is
// not finite (far may be infinite), has no direction, or whose near exceeds far meets nothing.
class RayTracer {
  public:
    // Builds on the calling arena (see run_with_threads). Keeps references to the scene's meshes: it has to outlive the
    // tracer, unchanged. Throws Cancelled, or Error when Embree fails.
    RayTracer(const Scene& scene, const Control& control);
    ~RayTracer();
    RayTracer(const RayTracer&) = delete;
    RayTracer& operator=(const RayTracer&) = delete;

    [[nodiscard]] Hit closest_hit(const Ray& ray, RayMask mask) const;
    // Distance [the ray's t] of what lies last on it, up to a finite far end; none: 0.
    [[nodiscard]] float farthest_hit(const Ray& ray, RayMask mask) const;
    [[nodiscard]] bool occluded(const Ray& ray, RayMask mask) const;

    // The same for many rays, traced as packets; hits.size() and results.size() equal rays.size().
    void closest_hits(std::span<const Ray> rays, std::span<Hit> hits, RayMask mask, Coherence coherence) const;
    // 1: something is in the way.
    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> results, RayMask mask, Coherence coherence) const;

    // Memory of the acceleration structures and their vertices.
    [[nodiscard]] std::size_t bytes() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace gg
