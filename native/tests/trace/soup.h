// Random triangle soups and the slow truth about rays through them.
#pragma once

#include <cstdint>
#include <vector>

#include "core/random.h"
#include "scene/scene.h"
#include "trace/ray_tracer.h"

namespace gg::test {

// Numbers in [-1, 1) by call order.
class Dice {
  public:
    explicit Dice(std::uint64_t seed) : seed_(seed) {}
    float number() { return 2 * unit_float(hash64(seed_, ++count_)) - 1; }
    Vec3 vector() {
        const float x = number();
        const float y = number();
        return {x, y, number()};
    }

  private:
    std::uint64_t seed_;
    std::uint64_t count_ = 0;
};

// Triangles of about `size` in the cube [-1, 1]^3.
inline Mesh make_soup(std::uint64_t seed, std::size_t triangles, float size) {
    Dice dice(seed);
    Mesh mesh;
    for (std::uint32_t index = 0; index < triangles; ++index) {
        const Vec3 centre = dice.vector();
        for (int corner = 0; corner < 3; ++corner) {
            mesh.positions.push_back(centre + size * dice.vector());
        }
        mesh.triangles.push_back({3 * index, 3 * index + 1, 3 * index + 2});
    }
    return mesh;
}

inline std::uint32_t add_instance(Scene& scene, std::uint32_t mesh, const Affine& to_world, std::uint32_t flags = 0) {
    Instance instance;
    instance.mesh = mesh;
    instance.to_world = to_world;
    instance.normal_to_world = normal_matrix(to_world.linear);
    instance.flags = flags;
    scene.instances.push_back(instance);
    return static_cast<std::uint32_t>(scene.instances.size() - 1);
}

struct TrueHit {
    std::uint32_t instance = kNone, triangle = kNone;
    double u = 0, v = 0, distance = 0;
    bool doubtful = false;  // some triangle's edge, or an end of the ray, is so near that rounding decides
};

// Closest hit by testing every triangle in double precision [Moeller and Trumbore 1997].
inline TrueHit brute_force_hit(const Scene& scene, const Ray& ray, std::uint32_t hidden_flag) {
    TrueHit best;
    best.distance = ray.far;
    for (std::uint32_t instance = 0; instance < scene.instances.size(); ++instance) {
        const Instance& placed = scene.instances[instance];
        if (placed.flags & hidden_flag) {
            continue;
        }
        const Mesh& mesh = scene.meshes[placed.mesh];
        const glm::dmat3 linear(placed.to_world.linear);
        const auto world = [&](std::uint32_t vertex) {
            return linear * Vec3d(mesh.positions[vertex]) + Vec3d(placed.to_world.translation);
        };
        for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
            const Vec3d p0 = world(mesh.triangles[triangle][0]);
            const Vec3d edge1 = world(mesh.triangles[triangle][1]) - p0;
            const Vec3d edge2 = world(mesh.triangles[triangle][2]) - p0;
            const Vec3d direction(ray.direction);
            const Vec3d p = glm::cross(direction, edge2);
            const double determinant = glm::dot(edge1, p);
            const double grazing = glm::length(edge1) * glm::length(edge2) * glm::length(direction);
            if (std::abs(determinant) < 1e-9 * grazing) {
                continue;
            }
            const Vec3d s = Vec3d(ray.origin) - p0;
            const Vec3d q = glm::cross(s, edge1);
            const double u = glm::dot(s, p) / determinant;
            const double v = glm::dot(direction, q) / determinant;
            const double t = glm::dot(edge2, q) / determinant;
            const double rounding = 1e-4 / std::max(1e-3, std::abs(determinant) / grazing);
            const double inside = std::min(std::min(u, v), 1 - u - v);
            const bool near_edge = std::abs(inside) < rounding;
            const bool in_range = t > ray.near - rounding && t < best.distance + rounding;
            if (in_range && inside > -rounding &&
                (near_edge || std::abs(t - ray.near) < rounding || std::abs(t - best.distance) < rounding)) {
                best.doubtful = true;
            }
            if (inside >= 0 && t >= ray.near && t <= best.distance) {
                best = {instance, triangle, u, v, t, best.doubtful};
            }
        }
    }
    return best;
}

}  // namespace gg::test
