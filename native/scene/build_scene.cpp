#include "scene/build_scene.h"

#include <utility>

#include "core/control.h"
#include "core/messages.h"
#include "core/parallel.h"
#include "scene/convert_mesh.h"
#include "scene/light_units.h"
#include "scene/place_instances.h"

namespace gg {

namespace {

void report_mesh(const ConvertedMesh& converted, Messages& messages) {
    const std::string& name = converted.mesh.name;
    bool had_triangles = false;
    for (std::size_t fault = 0; fault < kTriangleFaults; ++fault) {
        had_triangles |= converted.count[fault] > 0;
        if (fault != static_cast<std::size_t>(TriangleFault::kUsable) && converted.count[fault] > 0) {
            messages.add(name, fault_text(static_cast<TriangleFault>(fault)), converted.count[fault]);
        }
    }
    if (had_triangles && converted.mesh.triangles.empty()) {
        messages.add(name, "No triangle of the mesh is usable: not rendered");
    }
    if (converted.ignored_attributes) {
        messages.add(name, "Material slots, normals or texture coordinates do not fit the triangles: ignored");
    }
}

std::vector<Mesh> convert_meshes(const std::vector<MeshDescription>& descriptions, const Control& control,
                                 Messages& messages) {
    std::vector<Mesh> meshes(descriptions.size());
    std::vector<ConvertedMesh> converted(descriptions.size());
    parallel_for(descriptions.size(), 1, control,
                 [&](std::size_t index) { converted[index] = convert_mesh(descriptions[index], control); });
    for (std::size_t index = 0; index < meshes.size(); ++index) {
        report_mesh(converted[index], messages);  // here and not above: the order must not depend on threads
        meshes[index] = std::move(converted[index].mesh);
    }
    return meshes;
}

// Unknown materials read as kNone. There is at least one list.
std::vector<std::vector<std::uint32_t>> checked_lists(const SceneDescription& description) {
    auto lists = description.material_lists;
    for (auto& list : lists) {
        for (std::uint32_t& material : list) {
            material = material < description.materials.size() ? material : kNone;
        }
    }
    if (lists.empty()) {
        lists.emplace_back();
    }
    return lists;
}

Rgb checked_world(Rgb radiance, Messages& messages) {
    if (is_finite(radiance) && glm::all(glm::greaterThanEqual(radiance, Rgb(0)))) {
        return radiance;
    }
    messages.add("World", "Radiance is negative or not finite: taken as black");
    return Rgb(0);
}

}  // namespace

Scene build_scene(const SceneDescription& description, const Control& control, Messages& messages) {
    Scene scene;
    scene.meshes = convert_meshes(description.meshes, control, messages);
    scene.materials = description.materials;
    scene.material_lists = checked_lists(description);
    scene.world = checked_world(description.world, messages);
    for (const LightDescription& light : description.lights) {
        if (std::optional<Lamp> lamp = make_lamp(light, messages)) {
            scene.lamps.push_back(std::move(*lamp));
        }
    }
    scene.instances = place_instances(description.instances, scene.meshes, scene.material_lists.size(), messages);
    mark_enclosing(scene.instances, scene.lamps, control);
    return scene;
}

}  // namespace gg
