#include "scene/place_instances.h"

#include <algorithm>
#include <cmath>

#include "core/control.h"
#include "core/messages.h"
#include "scene/enclosing.h"

namespace gg {

namespace {

constexpr float kLeastScale = 1e-8F, kLargestScale = 1e8F;  // metres per unit: volumes stay well within floats
constexpr float kFlatScale = 1e-6F;                         // an axis below this share of the longest is flattened
constexpr float kFlatThickness = 1e-4F;                     // of the other axes, for a flattened one
constexpr float kLeastDeterminant = 1e-6F;                  // over the product of the axes' lengths

bool is_finite(const Affine& map) {
    return gg::is_finite(map.linear[0]) && gg::is_finite(map.linear[1]) && gg::is_finite(map.linear[2]) &&
           gg::is_finite(map.translation);
}

// Gives a flattened axis the direction across the other two. The mesh's middle stays where it is.
void thicken_axis(Affine& map, int axis, const Box& mesh_bounds) {
    const Vec3 second = map.linear[(axis + 1) % 3];
    const Vec3 third = map.linear[(axis + 2) % 3];
    const float scale = std::sqrt(length(second) * length(third));
    const bool mesh_is_flat = mesh_bounds.extent()[axis] <= kFlatScale * mesh_bounds.diameter();
    const Vec3 thickened = normalize_or_zero(cross(second, third)) * (mesh_is_flat ? scale : kFlatThickness * scale);
    map.translation += (map.linear[axis] - thickened) * mesh_bounds.center()[axis];
    map.linear[axis] = thickened;
}

}  // namespace

std::optional<Affine> make_invertible(const Affine& map, const Box& mesh_bounds) {
    if (!is_finite(map)) {
        return std::nullopt;
    }
    Affine result = map;
    const auto axis_length = [&](int axis) { return length(result.linear[axis]); };
    const float longest = std::max({axis_length(0), axis_length(1), axis_length(2)});
    if (!(longest >= kLeastScale && longest <= kLargestScale)) {
        return std::nullopt;
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (axis_length(axis) <= kFlatScale * longest) {
            thicken_axis(result, axis, mesh_bounds);
        }
    }
    const float determinant = std::abs(glm::determinant(result.linear));
    if (!(determinant > kLeastDeterminant * axis_length(0) * axis_length(1) * axis_length(2))) {
        return std::nullopt;
    }
    return result;
}

std::vector<Instance> place_instances(std::span<const InstanceDescription> instances, std::span<const Mesh> meshes,
                                      std::size_t list_count, Messages& messages) {
    std::vector<Instance> result;
    result.reserve(instances.size());
    for (const InstanceDescription& description : instances) {
        if (description.mesh >= meshes.size() || meshes[description.mesh].triangles.empty()) {
            continue;
        }
        const Mesh& mesh = meshes[description.mesh];
        const std::optional<Affine> to_world = make_invertible(description.to_world, mesh.bounds);
        if (!to_world) {
            messages.add(description.name, "Object is scaled to nothing or has no usable matrix: left out");
            continue;
        }
        Instance& instance = result.emplace_back();
        instance.name = description.name;
        instance.mesh = description.mesh;
        instance.materials = static_cast<std::uint32_t>(std::min<std::size_t>(description.materials, list_count - 1));
        instance.flags = description.flags;
        instance.stable_id = description.stable_id;
        instance.to_world = *to_world;
        instance.normal_to_world = normal_matrix(to_world->linear);
        instance.bounds = transformed(mesh.bounds, *to_world);
    }
    return result;
}

void mark_enclosing(std::vector<Instance>& instances, std::span<const Lamp> lamps, const Control& control) {
    std::vector<Box> boxes;
    boxes.reserve(instances.size() + lamps.size());
    for (const Instance& instance : instances) {
        boxes.push_back(instance.bounds);
    }
    for (const Lamp& lamp : lamps) {
        if (lamp.shape != LampShape::kDistant) {
            boxes.push_back({lamp.position, lamp.position});
        }
    }
    const std::vector<std::uint8_t> enclosing = find_enclosing(boxes, instances.size(), control);
    for (std::size_t index = 0; index < instances.size(); ++index) {
        instances[index].encloses = enclosing[index] != 0;
    }
}

}  // namespace gg
