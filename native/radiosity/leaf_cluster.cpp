#include "radiosity/leaf_cluster.h"

#include <algorithm>

namespace gg {

namespace {

// Large clusters are summed up by some of their faces: they get opened sooner or later.
std::uint32_t stride_of(const Hierarchy& hierarchy, const Node& node) {
    constexpr std::size_t kEnough = 8192;
    const bool glows = luminance(node.emission) > 0;  // by few of its faces, maybe
    return glows ? 1 : static_cast<std::uint32_t>(hierarchy.triangle_count(node) / kEnough + 1);
}

}  // namespace

FacingArea facing_area(const Hierarchy& hierarchy, const Node& node) {
    const Scene& scene = hierarchy.scene();
    const SceneFaces& faces = hierarchy.faces();
    FacingArea facing;
    const std::uint32_t stride = stride_of(hierarchy, node);
    const auto add = [&](std::uint32_t instance, std::uint32_t triangle) {
        const Vec3 area_vector = static_cast<float>(stride) * world_area_vector(scene, instance, triangle);
        const float area = length(area_vector);
        if (!(area > 0)) {
            return;
        }
        const auto [front, back, front_shelter, back_shelter] =
            faces.meshes[scene.instances[instance].mesh].exposure[triangle];
        const auto basis = form_basis(area_vector / area);
        const float front_side = front > 0 ? area : 0, back_side = back > 0 ? area : 0;
        for (std::size_t i = 0; i < kFormSize; ++i) {
            const float mirrored = i >= 1 && i <= 3 ? -basis[i] : basis[i];
            facing.area[i] += front_side * basis[i] + back_side * mirrored;
            facing.exposed[i] += front_side * front * basis[i] + back_side * back * mirrored;
            facing.sheltered[i] += front_side * front_shelter * basis[i] + back_side * back_shelter * mirrored;
        }
    };
    hierarchy.for_each_triangle(node, add, stride);
    return facing;
}

namespace {

constexpr float kMost = 256;  // faces that no light reaches make no light

// Luminance of the power that such light brings to faces with these moments, W.
float power_on(const std::array<float, kFormSize>& moments, const DirectionalForm& light) {
    float power = 0;
    for (std::size_t i = 0; i < kFormSize; ++i) {
        power += moments[i] * luminance(light.coefficients[i]);
    }
    return power;
}

float ratio(float alike, float shared_out) {
    return shared_out > 0 ? std::clamp(alike / shared_out, 0.0F, kMost) : 1.0F;
}

}  // namespace

float share_out_far(const FacingArea& facing, const DirectionalForm& light) {
    return ratio(power_on(facing.area, light), power_on(facing.exposed, light));
}

float share_out_near(const FacingArea& facing, const DirectionalForm& light) {
    return ratio(power_on(facing.area, light), power_on(facing.sheltered, light));
}

LeafCluster make_leaf_cluster(const Hierarchy& hierarchy, const Node& node) {
    const Scene& scene = hierarchy.scene();
    const SceneFaces& faces = hierarchy.faces();
    LeafCluster leaf;
    const std::uint32_t stride = stride_of(hierarchy, node);
    const auto add = [&](std::uint32_t instance, std::uint32_t triangle) {
        const FaceColors& colors = faces.colors[faces.instance_colors[instance]];
        const Vec3 area_vector = static_cast<float>(stride) * world_area_vector(scene, instance, triangle);
        const float area = length(area_vector);
        if (!(area > 0)) {
            return;
        }
        const Vec3 normal = area_vector / area;
        const Exposure& exposure = faces.meshes[scene.instances[instance].mesh].exposure[triangle];
        for (const bool back : {false, true}) {
            const float exposed = back ? exposure.back : exposure.front;
            const float sheltered = back ? exposure.back_shelter : exposure.front_shelter;
            if (exposed <= 0) {
                continue;
            }
            const Vec3 outward = back ? -normal : normal;
            leaf.area += area;
            const auto basis = form_basis(outward);
            for (std::size_t i = 0; i < kFormSize; ++i) {
                leaf.arriving[i] += exposed * area * basis[i];
                leaf.arriving_near[i] += sheltered * area * basis[i];
            }
            leaf.reflect_near.add_face(outward, sheltered * area, colors.reflectance[triangle]);
            leaf.reflect.add_face(outward, exposed * area, colors.reflectance[triangle]);
            if (!colors.emission.empty() && max_component(colors.emission[triangle]) > 0) {
                add_face(leaf.emission, colors.emission[triangle] * area, outward);
                leaf.emitted_power += kPi * area * colors.emission[triangle];
            }
        }
    };
    hierarchy.for_each_triangle(node, add, stride);
    return leaf;
}

}  // namespace gg
