#include "support/test_scenes.h"

#include "radiosity/link_estimate.h"

#include <cmath>

namespace gg::test {

std::uint32_t SceneBuilder::material(Rgb reflectance, Rgb emitted_radiance) {
    MaterialDescription result;
    result.name = "material " + std::to_string(description.materials.size());
    result.reflectance.factor = reflectance;
    result.emission.factor = emitted_radiance;
    description.materials.push_back(result);
    return static_cast<std::uint32_t>(description.materials.size() - 1);
}

std::uint32_t SceneBuilder::checkerboard(float dark, float bright) {
    ImageDescription image;
    image.name = "checkerboard";
    image.width = image.height = 8;
    image.color_space = ColorSpace::kLinear;
    image.filter_mode = FilterMode::kClosest;
    for (int texel = 0; texel < 64; ++texel) {
        const float value = (texel / 8 + texel) % 2 == 0 ? dark : bright;
        image.pixels.insert(image.pixels.end(), {value, value, value, 1.0F});
    }
    const std::uint32_t id = material(Rgb(1.0F));
    description.materials[id].reflectance.image = static_cast<std::uint32_t>(description.images.size());
    description.images.push_back(std::move(image));
    return id;
}

void SceneBuilder::add_mesh(MeshDescription mesh, std::uint32_t material) {
    InstanceDescription instance;
    instance.name = mesh.name;
    instance.mesh = static_cast<std::uint32_t>(description.meshes.size());
    instance.materials = static_cast<std::uint32_t>(description.material_lists.size());
    instance.stable_id = description.instances.size();
    description.material_lists.push_back({material});
    description.instances.push_back(instance);
    description.meshes.push_back(std::move(mesh));
}

void SceneBuilder::quad(Vec3 a, Vec3 b, Vec3 c, Vec3 d, std::uint32_t material, const std::string& name) {
    MeshDescription mesh;
    mesh.name = name;
    mesh.positions = {a, b, c, d};
    mesh.triangle_vertices = {0, 1, 2, 0, 2, 3};
    mesh.triangle_corners = mesh.triangle_vertices;
    mesh.corner_uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    add_mesh(std::move(mesh), material);
}

namespace {

// Corner k of a box: bit 0 x, bit 1 y, bit 2 z. Faces -x, +x, -y, +y, -z, +z, outward.
constexpr int kBoxFaces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

Vec3 box_corner(Vec3 lower, Vec3 upper, int k) {
    return {k & 1 ? upper.x : lower.x, k & 2 ? upper.y : lower.y, k & 4 ? upper.z : lower.z};
}

}  // namespace

void SceneBuilder::box(Vec3 lower, Vec3 upper, const std::array<std::uint32_t, 6>& materials, bool inward) {
    for (int face = 0; face < 6; ++face) {
        Vec3 c[4];
        for (int k = 0; k < 4; ++k) {
            c[k] = box_corner(lower, upper, kBoxFaces[face][inward ? 3 - k : k]);
        }
        quad(c[0], c[1], c[2], c[3], materials[face], "box face " + std::to_string(face));
    }
}

void SceneBuilder::solid(Vec3 lower, Vec3 upper, std::uint32_t material, const std::string& name) {
    MeshDescription mesh;
    mesh.name = name;
    for (int k = 0; k < 8; ++k) {
        mesh.positions.push_back(box_corner(lower, upper, k));
    }
    for (const auto& face : kBoxFaces) {
        for (const int k : {0, 1, 2, 0, 2, 3}) {
            mesh.triangle_vertices.push_back(static_cast<std::uint32_t>(face[k]));
        }
    }
    add_mesh(std::move(mesh), material);
}

void SceneBuilder::sphere(Vec3 center, float radius, int rings, std::uint32_t material, bool inward,
                          const std::string& name) {
    MeshDescription mesh;
    mesh.name = name;
    const int columns = 2 * rings;
    mesh.positions.push_back(center + Vec3(0, 0, radius));
    for (int ring = 1; ring < rings; ++ring) {
        const float theta = kPi * static_cast<float>(ring) / static_cast<float>(rings);
        for (int column = 0; column < columns; ++column) {
            const float phi = 2 * kPi * static_cast<float>(column) / static_cast<float>(columns);
            mesh.positions.push_back(center + radius * Vec3(std::sin(theta) * std::cos(phi),
                                                            std::sin(theta) * std::sin(phi), std::cos(theta)));
        }
    }
    mesh.positions.push_back(center - Vec3(0, 0, radius));
    const auto last = static_cast<std::uint32_t>(mesh.positions.size() - 1);
    const auto at = [&](int ring, int column) -> std::uint32_t {
        if (ring == 0 || ring == rings) {
            return ring == 0 ? 0 : last;
        }
        return static_cast<std::uint32_t>(1 + (ring - 1) * columns + column % columns);
    };
    const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh.triangle_vertices.insert(mesh.triangle_vertices.end(), {a, inward ? c : b, inward ? b : c});
    };
    for (int ring = 0; ring < rings; ++ring) {
        for (int column = 0; column < columns; ++column) {
            if (ring > 0) {
                triangle(at(ring, column), at(ring + 1, column), at(ring, column + 1));
            }
            if (ring + 1 < rings) {
                triangle(at(ring, column + 1), at(ring + 1, column), at(ring + 1, column + 1));
            }
        }
    }
    for (std::size_t i = 0; i < mesh.triangle_vertices.size(); ++i) {
        const Vec3 normal = (mesh.positions[mesh.triangle_vertices[i]] - center) / radius;
        mesh.triangle_corners.push_back(static_cast<std::uint32_t>(i));
        mesh.corner_normals.push_back(inward ? -normal : normal);
    }
    add_mesh(std::move(mesh), material);
}

void SceneBuilder::area_light(Vec3 position, Vec3 direction, float size, Rgb watts, const std::string& name) {
    LightDescription light;
    light.name = name;
    light.type = LightType::kArea;
    const Frame frame(-normalize_or_zero(direction));
    light.to_world.linear = Mat3(frame.tangent, frame.bitangent, frame.normal);
    light.to_world.translation = position;
    light.power = watts;
    light.size_x = light.size_y = size;
    light.stable_id = description.lights.size();
    description.lights.push_back(light);
}

void SceneBuilder::sun(Vec3 direction, Rgb irradiance, const std::string& name) {
    LightDescription light;
    light.name = name;
    light.type = LightType::kSun;
    const Frame frame(-normalize_or_zero(direction));
    light.to_world.linear = Mat3(frame.tangent, frame.bitangent, frame.normal);
    light.power = irradiance;
    light.angle = 0.02F;
    light.stable_id = description.lights.size();
    description.lights.push_back(light);
}

void SceneBuilder::point_light(Vec3 position, Rgb watts, const std::string& name) {
    LightDescription light;
    light.name = name;
    light.type = LightType::kPoint;
    light.to_world.translation = position;
    light.power = watts;
    light.stable_id = description.lights.size();
    description.lights.push_back(light);
}

Prepared::Prepared(SceneDescription input)
    : description(std::move(input)), scene(build_scene(description, control, messages)) {
    textures = std::make_unique<TextureSet>(load_textures(description, control, messages));
    colors = std::make_unique<SurfaceColors>(scene, *textures, messages);
    tracer = std::make_unique<RayTracer>(scene, control);
}

std::shared_ptr<const Solution> Prepared::solve(float quality) {
    return gg::solve(scene, *colors, *tracer, {quality}, control, statistics);
}

SceneFaces Prepared::faces() const {
    return make_scene_faces(scene, *colors, *tracer, control);
}

Link Prepared::estimate(const Hierarchy& hierarchy, NodeId receiver, NodeId sender, int rays) const {
    return estimate_link(hierarchy, *tracer, receiver, sender, rays, SampleSet::kLink, nullptr);
}

}  // namespace gg::test
