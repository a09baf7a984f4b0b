// Lighting: irradiance down the hierarchy, radiosity up.
#include <algorithm>
#include <cmath>

#include "radiosity/lighting.h"
#include "radiosity/quarter.h"

namespace gg {

void Lighting::push(NodeId id) {
    const auto& nodes = hierarchy_.nodes();
    const Node& node = nodes[id];
    if (node.parent == kNone || !is_surface(node)) {
        return;
    }
    if (node.kind != NodeKind::kElement) {
        received_[slot_[id]].far += received_[slot_[node.parent]].far;
        received_[slot_[id]].near += received_[slot_[node.parent]].near;
        return;
    }
    std::array<Rgb, 3>& corners = corners_[slot_[id]];
    if (nodes[node.parent].kind == NodeKind::kElement) {
        const std::array<Rgb, 3>& whole = corners_[slot_[node.parent]];
        const int quarter = static_cast<int>(id - nodes[node.parent].first_child);
        const std::array<Rgb, 3> inherited = quarter_of(whole, quarter);
        for (int k = 0; k < 3; ++k) {
            corners[k] += node.weight * inherited[k];
        }
        const Rgb near = near_[slot_[node.parent]];
        if (node.patch != kNone) {
            near_[slot_[id]] += near;
        } else if (nodes[node.parent].patch != kNone) {
            for (Rgb& corner : corners) {
                corner += patch_shelter(node.weight) * near;
            }
        }
    } else {
        const Received& light = received_[slot_[node.parent]];
        const Rgb irradiance =
            glm::max(node.weight * evaluate(light.far, node.normal) + node.shelter * evaluate(light.near, node.normal),
                     Rgb(0.0F));
        for (Rgb& corner : corners) {
            corner += irradiance;
        }
    }
    irradiance_[id] = glm::max((corners[0] + corners[1] + corners[2]) / 3.0F, Rgb(0.0F));
}

void Lighting::pull(NodeId id) {
    const auto& nodes = hierarchy_.nodes();
    const Node& node = nodes[id];
    if (!is_surface(node)) {
        radiosity_[id] = node.emission;
        return;
    }
    if (node.child_count == 0) {
        if (node.kind == NodeKind::kElement) {
            radiosity_[id] = node.emission + node.reflectance * irradiance_[id];
            float squares = 0;  // of a linear function over a triangle: the variance is their sum over 12
            for (const Rgb& corner : corners_[slot_[id]]) {
                const float difference = luminance(node.reflectance * (corner - irradiance_[id]));
                squares += difference * difference;
            }
            spread_[id] = std::sqrt(squares / 12);
            return;
        }
        if (known_[id]) {
            return;
        }
        const LeafCluster& leaf = leaves_[leaf_slot_[id]];
        const Received& light = received_[slot_[id]];
        intensity_[slot_[id]] = leaf.emission + leaf.reflect.apply(light.far) + leaf.reflect_near.apply(light.near);
        const Rgb reflected = glm::max(
            leaf.reflect.reflected_power(light.far) + leaf.reflect_near.reflected_power(light.near), Rgb(0.0F));
        const auto inverse_area = static_cast<float>(1.0 / std::max(leaf.area, 1e-30));
        radiosity_[id] = (leaf.emitted_power + reflected) * inverse_area;
        spread_[id] = 0;
        const FacingArea& facing = facing_[slot_[id]];
        Rgb arriving(0.0F);
        for (std::size_t i = 0; i < kFormSize; ++i) {
            arriving += facing.exposed[i] * light.far.coefficients[i];
            arriving += facing.sheltered[i] * light.near.coefficients[i];
        }
        irradiance_[id] = glm::max(arriving, Rgb(0.0F)) * inverse_area;
        return;
    }
    glm::dvec3 power(0.0), arriving(0.0);
    double area = 0, squares = 0;
    DirectionalForm intensity;
    for (NodeId child = node.first_child; child < node.first_child + node.child_count; ++child) {
        area += area_[child];
        power += area_[child] * glm::dvec3(radiosity_[child]);
        arriving += area_[child] * glm::dvec3(irradiance_[child]);
        const double brightness = luminance(radiosity_[child]);
        squares += area_[child] * (brightness * brightness + static_cast<double>(spread_[child]) * spread_[child]);
        if (node.kind != NodeKind::kElement) {
            if (is_cluster(nodes[child])) {
                intensity += intensity_[slot_[child]];
            } else {
                add_face(intensity, radiosity_[child] * (nodes[child].area / kPi), nodes[child].normal);
            }
        }
    }
    area_[id] = area;
    radiosity_[id] = Rgb(power / std::max(area, 1e-300));
    irradiance_[id] = Rgb(arriving / std::max(area, 1e-300));
    const double mean = luminance(radiosity_[id]);
    spread_[id] = static_cast<float>(std::sqrt(std::max(0.0, squares / std::max(area, 1e-300) - mean * mean)));
    if (node.kind != NodeKind::kElement) {
        intensity_[slot_[id]] = intensity;
    }
}

}  // namespace gg
