// The faces of every mesh as the solve needs them: cluster tree, prefix sums for area sampling, mean colours.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/vec.h"
#include "radiosity/cluster_tree.h"
#include "radiosity/face_groups.h"
#include "radiosity/patches.h"
#include "scene/scene.h"

namespace gg {

class Control;
class RayTracer;
class SurfaceColors;

// Colours of a mesh with one list of materials.
struct FaceColors {
    std::vector<Rgb> reflectance;         // mean per triangle
    Rgb mean_reflectance{0.0F};           // by area
    std::vector<Rgb> emission;            // mean radiance per triangle; empty when nothing emits
    std::vector<double> emission_prefix;  // of area * luminance of emission in tree order, size triangles + 1; or empty
};

// By how much each side of a triangle shares in the light that comes to its cluster from afar: none inside of a
// cushion, in full where much of the hemisphere is open. 0..1, never quite 0, 0 only where Sides says so.
struct Exposure {
    float front = 1, back = 1;
    float front_shelter = 0, back_shelter = 0;  // how much of its own instance a side sees, unless it is covered
    [[nodiscard]] float sum() const { return front + back; }
    [[nodiscard]] int sides() const { return (front > 0 ? 1 : 0) + (back > 0 ? 1 : 0); }
};

struct MeshFaces {
    ClusterTree tree;  // over triangles, object space
    FaceGroups groups;
    std::vector<Exposure> exposure;  // per triangle
    // Sums over the triangles in tree order, size triangles + 1: object-space area of every lit side, and times
    // exposure.
    std::vector<double> area_prefix, exposed_prefix;
    double area = 0;                  // object space, every triangle once
    std::vector<std::uint32_t> rank;  // triangle -> its place in tree order
};

struct SceneFaces {
    std::vector<MeshFaces> meshes;               // per mesh; empty for meshes that no instance uses
    std::vector<FaceColors> colors;              // per (mesh, material list) in use
    std::vector<std::uint32_t> instance_colors;  // per instance, into colors
    std::vector<float> instance_area;            // per instance: world area, m2, every triangle once
    ClusterTree instances;                       // over the instances that light reaches; no nodes when none
    // Sums over instances in the order of `instances`, size items + 1: of world area of every lit side, and * exposure.
    std::vector<double> instance_prefix, instance_exposed_prefix;
    std::vector<std::uint32_t> instance_ids;   // item of `instances` -> instance
    std::vector<std::uint32_t> instance_rank;  // instance -> place in the order of `instances`
    PatchForest patches;                       // of large faces that are covered in part
};

[[nodiscard]] SceneFaces make_scene_faces(const Scene& scene, const SurfaceColors& colors, const RayTracer& tracer,
                                          const Control& control);

// The item of [begin, end) that holds share u in [0, 1) of the range's sum; `prefix` as above.
[[nodiscard]] std::uint32_t sample_prefix(const std::vector<double>& prefix, std::uint32_t begin, std::uint32_t end,
                                          float u);

// World positions of a triangle's corners.
[[nodiscard]] inline std::array<Vec3, 3> world_triangle(const Scene& scene, std::uint32_t instance,
                                                        std::uint32_t triangle) {
    const Instance& placed = scene.instances[instance];
    const Mesh& mesh = scene.meshes[placed.mesh];
    const TriangleCorners& t = mesh.triangles[triangle];
    return {placed.to_world.point(mesh.positions[t[0]]), placed.to_world.point(mesh.positions[t[1]]),
            placed.to_world.point(mesh.positions[t[2]])};
}

// Area vector of the front: half of the world's cross product, m2.
[[nodiscard]] inline Vec3 world_area_vector(const Scene& scene, std::uint32_t instance, std::uint32_t triangle) {
    const Instance& placed = scene.instances[instance];
    const Mesh& mesh = scene.meshes[placed.mesh];
    const TriangleCorners& t = mesh.triangles[triangle];
    const Vec3 a = mesh.positions[t[0]];
    return 0.5F * (placed.normal_to_world * cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a));
}

}  // namespace gg
