// What the user asked for: the scene as plain data, straight from the C interface.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/vec.h"

namespace gg {

inline constexpr std::uint32_t kNone = 0xFFFFFFFFU;

enum class ColorSpace { kSrgb, kLinear };
enum class Extension { kRepeat, kExtend, kClip, kMirror };
enum class FilterMode { kLinear, kClosest };

// A file, or pixels when path is empty.
struct ImageDescription {
    std::string name;
    std::string path;
    std::vector<float> pixels;  // (height, width, 4) RGBA, bottom row first
    std::uint32_t width = 0, height = 0;
    ColorSpace color_space = ColorSpace::kSrgb;
    Extension extension = Extension::kRepeat;
    FilterMode filter_mode = FilterMode::kLinear;
};

// factor, times the image at uv_map(uv) when there is one.
struct ColorInput {
    Rgb factor{0.0F};
    std::uint32_t image = kNone;
    float uv_map[6] = {1, 0, 0, 0, 1, 0};  // 2x3 row-major
};

struct MaterialDescription {
    std::string name;
    ColorInput reflectance;
    ColorInput emission;  // radiance, W/(m2 sr)
};

struct MeshDescription {
    std::string name;
    std::vector<Vec3> positions;
    std::vector<std::uint32_t> triangle_vertices;  // 3 per triangle
    std::vector<std::uint32_t> triangle_corners;   // 3 per triangle, or empty
    std::vector<std::uint32_t> triangle_slots;     // 1 per triangle, or empty: all 0
    std::vector<Vec3> corner_normals;              // or empty: flat
    std::vector<Vec2> corner_uvs;                  // or empty: (0, 0)
};

struct InstanceDescription {
    std::string name;
    std::uint32_t mesh = 0;
    std::uint32_t materials = 0;  // index into SceneDescription::material_lists
    std::uint32_t flags = 0;      // GG_HIDDEN_FROM_...
    std::uint64_t stable_id = 0;
    Affine to_world;
};

enum class LightType { kPoint, kSpot, kSun, kArea };
enum class AreaShape { kRectangle, kEllipse };

// Units as in gg_light.
struct LightDescription {
    std::string name;
    LightType type = LightType::kPoint;
    Affine to_world;
    Rgb power{0.0F};
    float radius = 0;
    bool soft_falloff = false;
    float size_x = 0, size_y = 0;
    AreaShape shape = AreaShape::kRectangle;
    float spot_angle = 0, spot_blend = 0;
    float angle = 0;
    std::uint64_t stable_id = 0;
};

struct SceneDescription {
    std::vector<ImageDescription> images;
    std::vector<MaterialDescription> materials;
    std::vector<std::vector<std::uint32_t>> material_lists;  // material ids or kNone
    std::vector<MeshDescription> meshes;
    std::vector<InstanceDescription> instances;
    std::vector<LightDescription> lights;
    Rgb world{0.0F};  // radiance
};

enum class CameraType { kPerspective, kOrthographic };

struct CameraDescription {
    CameraType type = CameraType::kPerspective;
    Affine to_world;                 // orthonormal
    float window[4] = {0, 0, 0, 0};  // x_left, x_right, y_bottom, y_top; see gg_camera
    float clip_start = 0, clip_end = kInfinity;
};

}  // namespace gg
