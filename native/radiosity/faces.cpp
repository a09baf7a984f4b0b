#include "radiosity/faces.h"

#include <algorithm>
#include <map>

#include "core/parallel.h"
#include "gridgather.h"
#include "material/surface_color.h"
#include "radiosity/exposure.h"

namespace gg {

namespace {

constexpr std::uint32_t kTrianglesPerLeaf = 8;
constexpr std::uint32_t kInstancesPerLeaf = 1;
constexpr float kPatch = 1.0F / 64;  // smallest patch, as a share of the scene's size

MeshFaces make_mesh_faces(const Scene& scene, std::uint32_t instance, float scene_size, const RayTracer& tracer,
                          const Control& control) {
    const Mesh& mesh = scene.meshes[scene.instances[instance].mesh];
    std::vector<Box> boxes(mesh.triangles.size());
    parallel_for(boxes.size(), 4096, control, [&](std::size_t t) {
        for (const std::uint32_t vertex : mesh.triangles[t]) {
            boxes[t].extend(mesh.positions[vertex]);
        }
    });
    MeshFaces faces;
    faces.tree = build_cluster_tree(boxes, kTrianglesPerLeaf, control);
    faces.groups = group_faces(scene, instance, faces.tree, scene_size, control);
    faces.exposure = find_exposure(scene, instance, faces.groups, scene_size, tracer, control);
    faces.rank.resize(boxes.size());
    for (auto* prefix : {&faces.area_prefix, &faces.exposed_prefix}) {
        prefix->resize(boxes.size() + 1);
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const std::uint32_t triangle = faces.tree.order[i];
        const TriangleCorners& t = mesh.triangles[triangle];
        const Vec3 a = mesh.positions[t[0]];
        const double area = 0.5 * length(cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a));
        faces.area += area;
        const double exposed = faces.exposure[triangle].sum();
        faces.area_prefix[i + 1] = faces.area_prefix[i] + area * faces.exposure[triangle].sides();
        faces.exposed_prefix[i + 1] = faces.exposed_prefix[i] + area * exposed;
        faces.rank[triangle] = static_cast<std::uint32_t>(i);
    }
    return faces;
}

FaceColors make_face_colors(const Scene& scene, std::uint32_t instance, const MeshFaces& faces,
                            const SurfaceColors& colors, const Control& control) {
    const Mesh& mesh = scene.meshes[scene.instances[instance].mesh];
    const std::size_t count = mesh.triangles.size();
    FaceColors result;
    result.reflectance.resize(count);
    std::vector<Rgb> emission(count);
    parallel_for(count, 1024, control, [&](std::size_t t) {
        const std::uint32_t material = scene.material_of(instance, static_cast<std::uint32_t>(t));
        const Vec2 zero(0.0F);
        const Vec2* uv = mesh.uvs.empty() ? nullptr : &mesh.uvs[3 * t];
        const Vec2 a = uv ? uv[0] : zero, b = uv ? uv[1] : zero, c = uv ? uv[2] : zero;
        result.reflectance[t] = colors.mean_reflectance(material, a, b, c);
        emission[t] = colors.emits(material) ? colors.mean_emission(material, a, b, c) : Rgb(0.0F);
    });
    glm::dvec3 reflected(0.0);
    const auto area_of = [&](std::size_t i) {
        return (faces.area_prefix[i + 1] - faces.area_prefix[i]) / faces.exposure[faces.tree.order[i]].sides();
    };
    for (std::size_t i = 0; i < count; ++i) {
        reflected += (faces.exposed_prefix[i + 1] - faces.exposed_prefix[i]) *
                     glm::dvec3(result.reflectance[faces.tree.order[i]]);
    }
    result.mean_reflectance = Rgb(reflected / std::max(faces.exposed_prefix.back(), 1e-300));
    if (std::any_of(emission.begin(), emission.end(), [](Rgb e) { return luminance(e) > 0; })) {
        result.emission_prefix.resize(count + 1);
        for (std::size_t i = 0; i < count; ++i) {
            result.emission_prefix[i + 1] =
                result.emission_prefix[i] + area_of(i) * luminance(emission[faces.tree.order[i]]);
        }
        result.emission = std::move(emission);
    }
    return result;
}

}  // namespace

SceneFaces make_scene_faces(const Scene& scene, const SurfaceColors& colors, const RayTracer& tracer,
                            const Control& control) {
    SceneFaces faces;
    faces.meshes.resize(scene.meshes.size());
    faces.instance_colors.resize(scene.instances.size());
    faces.instance_area.resize(scene.instances.size());

    std::vector<std::uint32_t> used;  // the first instance of every mesh that light reaches
    std::vector<std::uint32_t> first_user;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> color_ids;
    std::vector<bool> seen(scene.meshes.size());
    Box bounds;
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        if (instance.flags & GG_HIDDEN_FROM_LIGHT) {
            continue;
        }
        faces.instance_ids.push_back(i);
        bounds.extend(instance.bounds);
        if (!seen[instance.mesh]) {
            seen[instance.mesh] = true;
            used.push_back(i);
        }
        const auto [entry, is_new] =
            color_ids.try_emplace({instance.mesh, instance.materials}, static_cast<std::uint32_t>(first_user.size()));
        if (is_new) {
            first_user.push_back(i);
        }
        faces.instance_colors[i] = entry->second;
    }
    const float scene_size = used.empty() ? 0 : bounds.diameter();
    parallel_for(used.size(), 1, control, [&](std::size_t i) {
        faces.meshes[scene.instances[used[i]].mesh] = make_mesh_faces(scene, used[i], scene_size, tracer, control);
    });
    faces.colors.resize(first_user.size());
    parallel_for(first_user.size(), 1, control, [&](std::size_t i) {
        const std::uint32_t instance = first_user[i];
        faces.colors[i] =
            make_face_colors(scene, instance, faces.meshes[scene.instances[instance].mesh], colors, control);
    });
    parallel_for(faces.instance_ids.size(), 1, control, [&](std::size_t i) {
        const std::uint32_t instance = faces.instance_ids[i];
        const std::size_t count = scene.meshes[scene.instances[instance].mesh].triangles.size();
        double area = 0;
        for (std::uint32_t t = 0; t < count; ++t) {
            area += length(world_area_vector(scene, instance, t));
        }
        faces.instance_area[instance] = static_cast<float>(area);
    });
    if (!faces.instance_ids.empty()) {
        std::vector<Box> boxes;
        boxes.reserve(faces.instance_ids.size());
        for (const std::uint32_t instance : faces.instance_ids) {
            boxes.push_back(scene.instances[instance].bounds);
        }
        faces.instances = build_cluster_tree(boxes, kInstancesPerLeaf, control);
        faces.instance_prefix.resize(boxes.size() + 1);
        faces.instance_exposed_prefix.resize(boxes.size() + 1);
        faces.instance_rank.resize(scene.instances.size());
        for (std::uint32_t i = 0; i < boxes.size(); ++i) {
            const std::uint32_t instance = faces.instance_ids[faces.instances.order[i]];
            const MeshFaces& mesh = faces.meshes[scene.instances[instance].mesh];
            const double scale = faces.instance_area[instance] / std::max(mesh.area, 1e-300);
            faces.instance_prefix[i + 1] = faces.instance_prefix[i] + scale * mesh.area_prefix.back();
            faces.instance_exposed_prefix[i + 1] =
                faces.instance_exposed_prefix[i] + scale * mesh.exposed_prefix.back();
            faces.instance_rank[instance] = i;
        }
        faces.patches = find_patches(scene, faces.instance_ids, kPatch * scene_size, tracer, control);
    }
    return faces;
}

std::uint32_t sample_prefix(const std::vector<double>& prefix, std::uint32_t begin, std::uint32_t end, float u) {
    const double target = prefix[begin] + u * (prefix[end] - prefix[begin]);
    const auto first = prefix.begin() + begin + 1;
    const auto found = std::upper_bound(first, prefix.begin() + end, target);
    return static_cast<std::uint32_t>(found - first) + begin;
}

}  // namespace gg
