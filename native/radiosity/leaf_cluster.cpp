#include "radiosity/leaf_cluster.h"

#include <algorithm>

namespace gg {

namespace {

// body(instance, triangle, unit front normal, area) for the faces of a cluster that have area. Large clusters are
// summed up by some of their faces, each for its neighbours too: they get opened sooner or later.
template <typename Body>
void for_each_face(const Hierarchy& hierarchy, const Node& node, const Body& body) {
    constexpr std::size_t kEnough = 8192;
    const bool glows = luminance(node.emission) > 0;  // by few of its faces, maybe
    const auto stride = glows ? 1 : static_cast<std::uint32_t>(hierarchy.triangle_count(node) / kEnough + 1);
    const auto visit = [&](std::uint32_t instance, std::uint32_t triangle) {
        const Vec3 vector = static_cast<float>(stride) * world_area_vector(hierarchy.scene(), instance, triangle);
        const float area = length(vector);
        if (area > 0) {
            body(instance, triangle, vector / area, area);
        }
    };
    hierarchy.for_each_triangle(node, visit, stride);
}

const Exposure& exposure_of(const Hierarchy& hierarchy, std::uint32_t instance, std::uint32_t triangle) {
    return hierarchy.faces().meshes[hierarchy.scene().instances[instance].mesh].exposure[triangle];
}

}  // namespace

FacingArea facing_area(const Hierarchy& hierarchy, const Node& node) {
    FacingArea facing;
    for_each_face(hierarchy, node, [&](std::uint32_t instance, std::uint32_t triangle, Vec3 normal, float area) {
        const auto [front, back, front_shelter, back_shelter] = exposure_of(hierarchy, instance, triangle);
        const auto basis = form_basis(normal);
        const float front_side = front > 0 ? area : 0, back_side = back > 0 ? area : 0;
        for (std::size_t i = 0; i < kFormSize; ++i) {
            const float mirrored = i >= 1 && i <= 3 ? -basis[i] : basis[i];
            facing.area[i] += front_side * basis[i] + back_side * mirrored;
            facing.exposed[i] += front_side * front * basis[i] + back_side * back * mirrored;
            facing.sheltered[i] += front_side * front_shelter * basis[i] + back_side * back_shelter * mirrored;
        }
    });
    return facing;
}

namespace {

constexpr float kMost = 64;  // one over the least exposure, exposure.cpp

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
    const SceneFaces& faces = hierarchy.faces();
    LeafCluster leaf;
    for_each_face(hierarchy, node, [&](std::uint32_t instance, std::uint32_t triangle, Vec3 normal, float area) {
        const FaceColors& colors = faces.colors[faces.instance_colors[instance]];
        const Exposure& exposure = exposure_of(hierarchy, instance, triangle);
        for (const bool back : {false, true}) {
            const float exposed = back ? exposure.back : exposure.front;
            const float sheltered = back ? exposure.back_shelter : exposure.front_shelter;
            if (exposed <= 0) {
                continue;
            }
            const Vec3 outward = back ? -normal : normal;
            leaf.area += area;
            leaf.reflect_near.add_face(outward, sheltered * area, colors.reflectance[triangle]);
            leaf.reflect.add_face(outward, exposed * area, colors.reflectance[triangle]);
            if (!colors.emission.empty() && max_component(colors.emission[triangle]) > 0) {
                add_face(leaf.emission, colors.emission[triangle] * area, outward);
                leaf.emitted_power += kPi * area * colors.emission[triangle];
            }
        }
    });
    return leaf;
}

}  // namespace gg
