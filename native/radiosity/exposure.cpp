#include "radiosity/exposure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/parallel.h"
#include "core/random.h"
#include "trace/ray_tracer.h"
#include "trace/surface_point.h"

namespace gg {

namespace {

constexpr std::uint32_t kFirstRays = 2;  // enough for a face that both get away from
constexpr std::uint32_t kRays = 6;
constexpr float kRoom = 0.5F;        // how far a ray must get, as a share of the instance's size
// Whose hemisphere is open by no more than the first share gets next to no light from outside, by the second and more
// about as much as any [measured: armchair, sofa, dresser, books, bear, peace lily of the furnished room].
constexpr float kCovered = 0.13F, kExposed = 0.5F;
constexpr float kLeast = 1.0F / 256;  // of a covered face: no cluster is without any area

// Rays [first, last) of a face that its own instance blocks.
std::uint32_t blocked_rays(const std::array<Vec3, 3>& corner, Vec3 normal, std::uint32_t instance, float reach, const Sequence4& sequence,
                           std::uint32_t first, std::uint32_t last, const RayTracer& tracer) {
    std::array<Ray, kRays> rays;
    std::array<Hit, kRays> hits;
    const Frame frame(normal);
    for (std::uint32_t k = first; k < last; ++k) {
        const Vec3 w = square_to_triangle(sequence(k, 0), sequence(k, 1));
        const Vec3 x = w.x * corner[0] + w.y * corner[1] + w.z * corner[2];
        const Vec2 disk = square_to_disk(sequence(k, 2), sequence(k, 3));
        const float z = std::sqrt(std::max(0.0F, 1 - dot(disk, disk)));
        rays[k - first] = {offset_origin(x, normal, reach), frame.to_world({disk.x, disk.y, z}), 0, reach};
    }
    const std::size_t count = last - first;
    tracer.closest_hits(std::span<const Ray>(rays.data(), count), std::span<Hit>(hits.data(), count), RayMask::kLight,
                        Coherence::kIncoherent);
    return static_cast<std::uint32_t>(std::count_if(hits.begin(), hits.begin() + count,
                                                    [&](const Hit& hit) { return hit.instance == instance; }));
}

struct Side {
    float exposure, shelter;
};

Side look_around(const std::array<Vec3, 3>& corner, Vec3 normal, std::uint32_t instance, float reach, std::uint64_t seed,
                    const RayTracer& tracer) {
    const Sequence4 sequence(seed);
    std::uint32_t blocked = blocked_rays(corner, normal, instance, reach, sequence, 0, kFirstRays, tracer);
    if (blocked == 0) {
        return {1, kLeast};
    }
    blocked += blocked_rays(corner, normal, instance, reach, sequence, kFirstRays, kRays, tracer);
    const float open = 1 - static_cast<float>(blocked) / kRays;
    const float exposed = std::clamp((open - kCovered) / (kExposed - kCovered), kLeast, 1.0F);
    return {exposed, std::max(kLeast, exposed * (1 - open))};
}

}  // namespace

std::vector<Exposure> find_exposure(const Scene& scene, std::uint32_t instance, const RayTracer& tracer,
                                    const Control& control) {
    const Instance& placed = scene.instances[instance];
    const std::size_t count = scene.meshes[placed.mesh].triangles.size();
    const float reach = kRoom * placed.bounds.diameter();
    std::vector<Exposure> exposure(count);
    parallel_for(count, 512, control, [&](std::size_t t) {
        const auto triangle = static_cast<std::uint32_t>(t);
        const auto corner = world_triangle(scene, instance, triangle);
        const Vec3 front = normalize_or_zero(world_area_vector(scene, instance, triangle));
        const Sides sides = scene.sides_of(instance, triangle);
        const std::uint64_t seed = hash64(placed.stable_id, t);
        const Side none{0, 0};
        const Side a = sides == Sides::kBack ? none : look_around(corner, front, instance, reach, hash64(seed, 0), tracer);
        const Side b =
            sides == Sides::kFront ? none : look_around(corner, -front, instance, reach, hash64(seed, 1), tracer);
        exposure[t] = {a.exposure, b.exposure, a.shelter, b.shelter};
    });
    return exposure;
}

}  // namespace gg
