// Scenes built through the C interface alone.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "gridgather.h"

namespace gg::test {

inline constexpr float kIdentity[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

// Owners that keep tests free of leaks when they fail.
struct Scene {
    Scene() { gg_scene_create(&handle); }
    ~Scene() { gg_scene_destroy(handle); }
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;
    gg_scene* handle = nullptr;
};

struct Render {
    ~Render() { gg_render_destroy(handle); }
    Render() = default;
    Render(const Render&) = delete;
    Render& operator=(const Render&) = delete;
    gg_render* handle = nullptr;
};

inline gg_material grey_material(float reflectance) {
    gg_material material{};
    material.name = "grey";
    for (int channel = 0; channel < 3; ++channel) {
        material.reflectance.factor[channel] = reflectance;
    }
    material.reflectance.image = GG_NONE;
    material.emission.image = GG_NONE;
    return material;
}

// `side` x `side` quads of bumps of that height over [-2, 2]^2.
struct Ground {
    Ground(std::uint32_t side, float height) {
        for (std::uint32_t y = 0; y <= side; ++y) {
            for (std::uint32_t x = 0; x <= side; ++x) {
                const float u = 4 * static_cast<float>(x) / static_cast<float>(side) - 2;
                const float v = 4 * static_cast<float>(y) / static_cast<float>(side) - 2;
                const float z = height * std::sin(9 * u) * std::sin(7 * v);
                positions.insert(positions.end(), {u, v, z});
            }
        }
        for (std::uint32_t y = 0; y < side; ++y) {
            for (std::uint32_t x = 0; x < side; ++x) {
                const std::uint32_t corner = y * (side + 1) + x;
                triangles.insert(triangles.end(), {corner, corner + 1, corner + side + 2});
                triangles.insert(triangles.end(), {corner, corner + side + 2, corner + side + 1});
            }
        }
        mesh.name = "ground";
        mesh.vertex_count = static_cast<std::uint32_t>(positions.size() / 3);
        mesh.positions = positions.data();
        mesh.triangle_count = static_cast<std::uint32_t>(triangles.size() / 3);
        mesh.triangle_vertices = triangles.data();
    }
    Ground(const Ground&) = delete;
    Ground& operator=(const Ground&) = delete;

    std::vector<float> positions;
    std::vector<std::uint32_t> triangles;
    gg_mesh mesh{};
};

// An area lamp of 1 m by 1 m, 2 m above the origin, shining down.
inline gg_light area_lamp(float power) {
    gg_light light{};
    light.name = "lamp";
    light.type = GG_LIGHT_AREA;
    for (int index = 0; index < 12; ++index) {
        light.matrix[index] = kIdentity[index];
    }
    light.matrix[11] = 2;
    light.power[0] = light.power[1] = light.power[2] = power;
    light.size_x = light.size_y = 1;
    return light;
}

// Grey ground under the lamp. False when any call failed.
inline bool fill_scene(gg_scene* scene, const gg_mesh& mesh, float power = 100) {
    std::uint32_t material_id = GG_NONE;
    std::uint32_t mesh_id = GG_NONE;
    const gg_material material = grey_material(0.5F);
    const gg_light light = area_lamp(power);
    gg_instances instances{};
    instances.count = 1;
    instances.meshes = &mesh_id;
    instances.matrices = kIdentity;
    instances.slot_count = 1;
    instances.materials = &material_id;
    return gg_scene_add_material(scene, &material, &material_id) == GG_OK &&
           gg_scene_add_mesh(scene, &mesh, &mesh_id) == GG_OK && gg_scene_add_instances(scene, &instances) == GG_OK &&
           gg_scene_add_light(scene, &light) == GG_OK;
}

// From 5 m above the origin, looking down on about 5 m by 5 m.
inline gg_camera camera_above() {
    gg_camera camera{};
    for (int index = 0; index < 12; ++index) {
        camera.matrix[index] = kIdentity[index];
    }
    camera.matrix[11] = 5;
    const float window[4] = {-0.5F, 0.5F, -0.5F, 0.5F};
    for (int index = 0; index < 4; ++index) {
        camera.window[index] = window[index];
    }
    camera.clip_start = 0.1F;
    camera.clip_end = 100;
    return camera;
}

inline gg_settings small_settings() {
    gg_settings settings{};
    settings.method = GG_METHOD_SOLUTION;
    settings.width = 48;
    settings.height = 40;
    settings.samples = 4;
    settings.quality = 0.1F;
    settings.threads = 2;
    return settings;
}

}  // namespace gg::test
