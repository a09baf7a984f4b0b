// The scene as the stages read it: valid triangles only, instances, lamps in world space with radiances.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/vec.h"
#include "scene/description.h"

namespace gg {

using TriangleCorners = std::array<std::uint32_t, 3>;

// Which sides of a triangle light can reach. A closed solid is dark inside.
enum class Sides : std::uint8_t { kBoth, kFront, kBack };

[[nodiscard]] constexpr bool has_side(Sides sides, bool back) {
    return sides == Sides::kBoth || back == (sides == Sides::kBack);
}

// One mesh in object space. Front is the side to which (v1 - v0) x (v2 - v0) points.
struct Mesh {
    std::string name;
    std::vector<Vec3> positions;                    // finite
    std::vector<TriangleCorners> triangles;         // into positions; distinct vertices, area > 0
    std::vector<TriangleCorners> shading_vertices;  // into normals: corners that share position and normal share one
    std::vector<Vec3> normals;                      // unit shading normal per shading vertex, in front
    std::vector<Vec2> uvs;                          // 3 per triangle, or empty: (0, 0)
    std::vector<std::uint32_t> slots;               // material slot per triangle, or empty: all 0
    std::vector<Sides> sides;                       // per triangle
    Box bounds;
};

struct Instance {
    std::string name;
    std::uint32_t mesh = 0;
    std::uint32_t materials = 0;  // index into Scene::material_lists
    std::uint32_t flags = 0;      // GG_HIDDEN_FROM_...
    std::uint64_t stable_id = 0;
    bool encloses = false;  // a lamp or another instance lies within its bounds: its solids count as open on both sides
    Affine to_world;
    Mat3 normal_to_world{1.0F};  // unnormalised, see normal_matrix
    Box bounds;                  // world
};

enum class LampShape { kPoint, kSphere, kRectangle, kEllipse, kDistant };

// A lamp in world space. Lamps cast no shadow.
struct Lamp {
    std::string name;
    LampShape shape = LampShape::kPoint;
    std::uint64_t stable_id = 0;
    Vec3 position{0.0F};                // centre
    Vec3 half_x{0.0F}, half_y{0.0F};    // kRectangle, kEllipse: centre to edge, orthogonal or sheared as placed
    Vec3 direction{0.0F, 0.0F, -1.0F};  // unit, where it shines to: kRectangle, kEllipse, kDistant, spots
    float radius = 0;                   // kSphere, m
    bool faces_receivers = false;       // kSphere: a disk in its place instead, that faces every receiver
    Rgb radiance{0.0F};                 // W/(m2 sr), towards its brightest direction; kPoint: intensity, W/sr
    Rgb irradiance{0.0F};               // kDistant: W/m2 on a surface that faces it
    float cos_half_angle = 1;           // kDistant: of the disk in the sky
    bool is_spot = false;
    float spot_cos = -1, spot_smooth = 0;  // see spot_factor() in light_units.h
};

struct Scene {
    std::vector<Mesh> meshes;
    std::vector<Instance> instances;  // of meshes that have triangles, in the description's order
    std::vector<std::vector<std::uint32_t>> material_lists;
    std::vector<MaterialDescription> materials;
    std::vector<Lamp> lamps;
    Rgb world{0.0F};  // radiance of the sky

    // Material id of a triangle, or kNone.
    [[nodiscard]] std::uint32_t material_of(std::uint32_t instance, std::uint32_t triangle) const {
        const auto& list = material_lists[instances[instance].materials];
        const auto& slots = meshes[instances[instance].mesh].slots;
        const std::size_t slot = slots.empty() ? 0 : slots[triangle];
        return list.empty() ? kNone : list[std::min(slot, list.size() - 1)];
    }
    [[nodiscard]] Sides sides_of(std::uint32_t instance, std::uint32_t triangle) const {
        // A solid that is inside out is more likely a room than a mistake: its faces look inwards on purpose.
        const Sides sides = meshes[instances[instance].mesh].sides[triangle];
        return instances[instance].encloses || sides == Sides::kBack ? Sides::kBoth : sides;
    }
};

}  // namespace gg
