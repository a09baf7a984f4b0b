// gg_scene_...: collects the description.
#include "api/convert_scene.h"
#include "api/convert_settings.h"
#include "api/guard.h"
#include "api/handles.h"
#include "render/capture.h"

namespace {

gg_scene& open_scene(gg_scene* scene) {
    gg_scene& result = gg::checked_scene(scene);
    if (result.frozen) {
        throw gg::Error(GG_WRONG_STATE, "the scene is frozen: it has been rendered");
    }
    return result;
}

// Appends, and tells the new item's index.
template <typename T>
void append(std::vector<T>& items, T item, uint32_t* id) {
    gg::require(items.size() < GG_NONE, "too many");
    items.push_back(std::move(item));
    *id = static_cast<uint32_t>(items.size() - 1);
}

}  // namespace

gg_status gg_scene_create(gg_scene** scene) {
    return gg::guarded([&] {
        gg::require(scene != nullptr, "no place for the scene");
        *scene = new gg_scene;
    });
}

void gg_scene_destroy(gg_scene* scene) {
    (void)gg::guarded([&] {
        if (scene != nullptr) {
            delete &gg::checked_scene(scene);
        }
    });
}

gg_status gg_scene_add_image(gg_scene* scene, const gg_image* image, uint32_t* image_id) {
    return gg::guarded([&] {
        gg_scene& target = open_scene(scene);
        gg::require(image != nullptr && image_id != nullptr, "no image, or no place for its id");
        append(target.cache.description.images, gg::convert(*image), image_id);
    });
}

gg_status gg_scene_add_material(gg_scene* scene, const gg_material* material, uint32_t* material_id) {
    return gg::guarded([&] {
        gg_scene& target = open_scene(scene);
        gg::require(material != nullptr && material_id != nullptr, "no material, or no place for its id");
        gg::SceneDescription& description = target.cache.description;
        append(description.materials, gg::convert(*material, description.images.size()), material_id);
    });
}

gg_status gg_scene_add_mesh(gg_scene* scene, const gg_mesh* mesh, uint32_t* mesh_id) {
    return gg::guarded([&] {
        gg_scene& target = open_scene(scene);
        gg::require(mesh != nullptr && mesh_id != nullptr, "no mesh, or no place for its id");
        append(target.cache.description.meshes, gg::convert(*mesh), mesh_id);
    });
}

gg_status gg_scene_add_instances(gg_scene* scene, const gg_instances* instances) {
    return gg::guarded([&] {
        gg_scene& target = open_scene(scene);
        gg::require(instances != nullptr, "no instances");
        gg::SceneDescription& description = target.cache.description;
        const auto slots = gg::convert_slots(*instances, description.materials.size());
        const auto known = target.material_lists.find(slots);
        const bool is_new = known == target.material_lists.end();
        const auto list = is_new ? static_cast<uint32_t>(description.material_lists.size()) : known->second;
        const auto added = gg::convert(*instances, description, list);
        gg::require(description.instances.size() + added.size() < GG_NONE, "too many instances");
        description.instances.reserve(description.instances.size() + added.size());
        if (is_new) {
            description.material_lists.push_back(slots);
            target.material_lists.emplace(slots, list);
        }
        description.instances.insert(description.instances.end(), added.begin(), added.end());
    });
}

gg_status gg_scene_add_light(gg_scene* scene, const gg_light* light) {
    return gg::guarded([&] {
        gg_scene& target = open_scene(scene);
        gg::require(light != nullptr, "no light");
        target.cache.description.lights.push_back(gg::convert(*light));
    });
}

gg_status gg_scene_set_world(gg_scene* scene, const float radiance[3]) {
    return gg::guarded([&] { open_scene(scene).cache.description.world = gg::convert_world(radiance); });
}

gg_status gg_scene_add_message(gg_scene* scene, const char* object, const char* text) {
    return gg::guarded(
        [&] { open_scene(scene).messages.add(object != nullptr ? object : "", text != nullptr ? text : ""); });
}

gg_status gg_scene_capture(gg_scene* scene, const gg_camera* camera, const gg_settings* settings, const char* path) {
    return gg::guarded([&] {
        gg_scene& source = open_scene(scene);
        gg::require(settings != nullptr && path != nullptr, "no settings, or no path");
        gg::write_capture(source.cache.description, gg::convert_settings(camera, *settings), path);
    });
}
