#include "api/convert_scene.h"

#include <algorithm>
#include <span>

#include "api/guard.h"

namespace gg {

namespace {

constexpr std::uint32_t kLargestImage = 1U << 16;

void require_finite(const float* values, std::size_t count, const char* what) {
    require(std::all_of(values, values + count, [](float value) { return std::isfinite(value); }), what);
}

void require_below(std::span<const std::uint32_t> values, std::size_t limit, const char* what) {
    require(std::all_of(values.begin(), values.end(), [limit](std::uint32_t value) { return value < limit; }), what);
}

void require_range(std::int32_t value, std::int32_t last, const char* what) {
    require(value >= 0 && value <= last, what);
}

ColorInput convert(const gg_color_input& color, std::size_t image_count) {
    require_finite(color.factor, 3, "a colour's factor is not finite");
    require(*std::min_element(color.factor, color.factor + 3) >= 0, "a colour's factor is negative");
    require(color.image == GG_NONE || color.image < image_count, "a colour's image id is unknown");
    require_finite(color.uv_map, 6, "a colour's uv_map is not finite");
    ColorInput result;
    result.factor = {color.factor[0], color.factor[1], color.factor[2]};
    result.image = color.image == GG_NONE ? kNone : color.image;
    if (std::any_of(color.uv_map, color.uv_map + 6, [](float value) { return value != 0; })) {
        std::copy_n(color.uv_map, 6, result.uv_map);
    }
    return result;
}

template <typename T>
std::vector<T> copy_vectors(const float* values, std::size_t count) {
    std::vector<T> result(values != nullptr ? count : 0);
    for (std::size_t index = 0; index < result.size(); ++index) {
        for (int component = 0; component < T::length(); ++component) {
            result[index][component] = values[index * T::length() + component];
        }
    }
    return result;
}

}  // namespace

std::string text(const char* value) {
    return value != nullptr ? value : "";
}

Affine convert_matrix(const float* m) {
    return {Mat3(Vec3(m[0], m[4], m[8]), Vec3(m[1], m[5], m[9]), Vec3(m[2], m[6], m[10])), Vec3(m[3], m[7], m[11])};
}

ImageDescription convert(const gg_image& image) {
    require_range(image.color_space, GG_COLOR_LINEAR, "unknown color_space");
    require_range(image.extension, GG_EXTENSION_MIRROR, "unknown extension");
    require_range(image.filter_mode, GG_FILTER_CLOSEST, "unknown filter_mode");
    ImageDescription result;
    result.name = text(image.name);
    result.path = text(image.path);
    result.color_space = static_cast<ColorSpace>(image.color_space);
    result.extension = static_cast<Extension>(image.extension);
    result.filter_mode = static_cast<FilterMode>(image.filter_mode);
    if (result.path.empty()) {
        require(image.pixels != nullptr, "an image has neither path nor pixels");
        require(image.width >= 1 && image.height >= 1 && image.width <= kLargestImage && image.height <= kLargestImage,
                "an image's width or height is out of range");
        result.width = image.width;
        result.height = image.height;
        result.pixels.assign(image.pixels, image.pixels + std::size_t{4} * image.width * image.height);
    }
    return result;
}

MaterialDescription convert(const gg_material& material, std::size_t image_count) {
    return {text(material.name), convert(material.reflectance, image_count), convert(material.emission, image_count)};
}

MeshDescription convert(const gg_mesh& mesh) {
    const std::size_t indices = std::size_t{3} * mesh.triangle_count;
    require(mesh.vertex_count == 0 || mesh.positions != nullptr, "a mesh has no positions");
    require(mesh.triangle_count == 0 || mesh.triangle_vertices != nullptr, "a mesh has no triangle_vertices");
    MeshDescription result;
    result.name = text(mesh.name);
    result.positions = copy_vectors<Vec3>(mesh.positions, mesh.vertex_count);
    if (mesh.triangle_count == 0) {
        return result;
    }
    require_below({mesh.triangle_vertices, indices}, mesh.vertex_count, "a triangle's vertex is out of range");
    result.triangle_vertices.assign(mesh.triangle_vertices, mesh.triangle_vertices + indices);
    if (mesh.triangle_slots != nullptr) {
        result.triangle_slots.assign(mesh.triangle_slots, mesh.triangle_slots + mesh.triangle_count);
    }
    if (mesh.corner_count > 0) {
        require(mesh.triangle_corners != nullptr, "a mesh has corners but no triangle_corners");
        require_below({mesh.triangle_corners, indices}, mesh.corner_count, "a triangle's corner is out of range");
        result.triangle_corners.assign(mesh.triangle_corners, mesh.triangle_corners + indices);
        result.corner_normals = copy_vectors<Vec3>(mesh.corner_normals, mesh.corner_count);
        result.corner_uvs = copy_vectors<Vec2>(mesh.corner_uvs, mesh.corner_count);
    }
    return result;
}

LightDescription convert(const gg_light& light) {
    require_range(light.type, GG_LIGHT_AREA, "unknown light type");
    require_range(light.shape, GG_AREA_ELLIPSE, "unknown area shape");
    LightDescription result;
    result.name = text(light.name);
    result.type = static_cast<LightType>(light.type);
    result.to_world = convert_matrix(light.matrix);
    result.power = {light.power[0], light.power[1], light.power[2]};
    result.radius = light.radius;
    result.size_x = light.size_x;
    result.size_y = light.size_y;
    result.shape = static_cast<AreaShape>(light.shape);
    result.spot_angle = light.spot_angle;
    result.spot_blend = light.spot_blend;
    result.soft_falloff = light.soft_falloff != 0;
    result.angle = light.angle;
    result.stable_id = light.stable_id;
    return result;
}

std::vector<std::uint32_t> convert_slots(const gg_instances& instances, std::size_t material_count) {
    require(instances.slot_count == 0 || instances.materials != nullptr, "instances have slots but no materials");
    std::vector<std::uint32_t> slots(instances.slot_count);
    for (std::size_t slot = 0; slot < slots.size(); ++slot) {
        const std::uint32_t material = instances.materials[slot];
        require(material == GG_NONE || material < material_count, "a slot's material id is unknown");
        slots[slot] = material == GG_NONE ? kNone : material;
    }
    return slots;
}

std::vector<InstanceDescription> convert(const gg_instances& instances, const SceneDescription& scene,
                                         std::uint32_t materials) {
    require(instances.count == 0 || (instances.meshes != nullptr && instances.matrices != nullptr),
            "instances have no meshes or no matrices");
    std::vector<InstanceDescription> result(instances.count);
    for (std::size_t index = 0; index < result.size(); ++index) {
        const std::uint32_t mesh = instances.meshes[index];
        require(mesh < scene.meshes.size(), "an instance's mesh id is unknown");
        InstanceDescription& instance = result[index];
        instance.name = instances.names != nullptr ? text(instances.names[index]) : scene.meshes[mesh].name;
        instance.mesh = mesh;
        instance.materials = materials;
        instance.flags = instances.flags != nullptr ? instances.flags[index] : 0;
        require((instance.flags & ~(GG_HIDDEN_FROM_CAMERA | GG_HIDDEN_FROM_LIGHT)) == 0, "unknown instance flags");
        instance.stable_id =
            instances.stable_ids != nullptr ? instances.stable_ids[index] : scene.instances.size() + index;
        instance.to_world = convert_matrix(instances.matrices + 12 * index);
    }
    return result;
}

Rgb convert_world(const float* radiance) {
    require(radiance != nullptr, "no radiance");
    require_finite(radiance, 3, "the world's radiance is not finite");
    require(*std::min_element(radiance, radiance + 3) >= 0, "the world's radiance is negative");
    return {radiance[0], radiance[1], radiance[2]};
}

}  // namespace gg
