// Lighting: light over links.
#include <algorithm>

#include "radiosity/lighting.h"

namespace gg {

// The leaf cluster or the element of the whole triangle below a cluster; kNone for a side that no light reaches.
NodeId Lighting::leaf_at(NodeId sender, const NearHit& hit) const {
    const auto& nodes = hierarchy_.nodes();
    NodeId id = sender;
    while (is_cluster(nodes[id]) && nodes[id].child_count > 0) {
        const NodeId end = nodes[id].first_child + nodes[id].child_count;
        NodeId child = nodes[id].first_child;
        while (child < end) {
            const Node& part = nodes[child];
            if (part.kind == NodeKind::kElement ? part.source == hit.triangle && part.back == hit.back
                                                : hierarchy_.contains(part, hit.instance, hit.triangle)) {
                break;
            }
            ++child;
        }
        if (child == end) {
            return kNone;
        }
        id = child;
    }
    return id;
}

Rgb Lighting::radiosity_at(const NearHit& hit) const {
    if (hit.leaf == kNone) {
        return Rgb(0.0F);
    }
    if (hierarchy_[hit.leaf].kind == NodeKind::kElement) {
        return radiosity_[hit.leaf];
    }
    const SceneFaces& faces = hierarchy_.faces();
    const FaceColors& colors = faces.colors[faces.instance_colors[hit.instance]];
    const Vec3 front = normalize_or_zero(world_area_vector(hierarchy_.scene(), hit.instance, hit.triangle));
    Exposure exposure = faces.meshes[hierarchy_.scene().instances[hit.instance].mesh].exposure[hit.triangle];
    // One of few rays may hit a face that has far more light than its cluster: as often as not too often.
    constexpr float kMost = 4;
    const float most = kMost * facing_[slot_[hit.leaf]].exposed[0] / std::max(facing_[slot_[hit.leaf]].area[0], 1e-30F);
    exposure.front = std::min(exposure.front, most);
    exposure.back = std::min(exposure.back, most);
    const Rgb irradiance = on_face(shining_[slot_[hit.leaf]], exposure, hit.back, hit.back ? -front : front);
    const Rgb emission = colors.emission.empty() ? Rgb(0.0F) : colors.emission[hit.triangle];
    return kPi * emission + colors.reflectance[hit.triangle] * irradiance;
}

void Lighting::gather_near(const Link& link, DirectionalForm& form, std::array<Rgb, 3>& corners) const {
    const float share = gain_ / static_cast<float>(link.ray_count);
    Rgb mean(0.0F);
    std::array<Rgb, 3> lean{};
    for (const NearHit& hit : hits_.subspan(link.first_hit, link.hit_count)) {
        const Rgb radiosity = radiosity_at(hit);
        mean += share * radiosity;
        for (int k = 0; k < 3; ++k) {
            lean[k] += gain_ * hit.lean[k] * radiosity;
        }
    }
    for (Rgb& corner : corners) {
        corner += mean;
    }
    form.coefficients[0] += mean;
    // No face gets next to nothing, whatever few rays say: what all get is then well-conditioned to share out.
    const Rgb size = glm::sqrt(lean[0] * lean[0] + lean[1] * lean[1] + lean[2] * lean[2]);
    constexpr float kMostLean = 0.5F;
    const Rgb scale = glm::min(Rgb(1.0F), kMostLean * mean / glm::max(size, Rgb(1e-30F)));
    for (int k = 0; k < 3; ++k) {
        form.coefficients[1 + k] += scale * lean[k];
    }
}

void Lighting::gather(NodeId receiver) {
    const auto& nodes = hierarchy_.nodes();
    const Node& to = nodes[receiver];
    std::array<Rgb, 3> corners{};
    DirectionalForm form, near;
    Rgb near_mean(0.0F);
    for (std::uint32_t i = link_begin_[receiver]; i < link_begin_[receiver + 1]; ++i) {
        const Link& link = links_[link_order_[i]];
        const Node& from = nodes[link.sender];
        const float factor = link.form_factor * link.visibility;
        if (!(factor > 0)) {
            continue;
        }
        if (link.near) {
            gather_near(link, near, corners);
            continue;
        }
        Rgb arriving;
        if (!is_surface(from)) {
            arriving = factor * radiosity_[link.sender];
        } else if (is_cluster(from)) {
            const Vec3 towards = normalize_or_zero(to.center - from.center);
            arriving = gain_ * kPi * factor * evaluate_clamped(intensity_[slot_[link.sender]], towards);
        } else {
            arriving = gain_ * factor * balance_[from.instance] * link.brightness * radiosity_[link.sender];
        }
        if (to.kind == NodeKind::kElement) {
            for (int k = 0; k < 3; ++k) {
                corners[k] += (1 - link.near_share) * link.shape[k] * arriving;
            }
            near_mean += link.near_share * arriving;
        } else {
            DirectionalForm cone;
            add_cone(cone, Rgb(1.0F), link.shape);
            cone *= arriving * share_out_far(facing_[slot_[receiver]], cone);
            form += cone;
        }
    }
    if (to.kind == NodeKind::kElement) {
        const float shared_out = 1 / to.exposure;
        corners_[slot_[receiver]] = {shared_out * corners[0], shared_out * corners[1], shared_out * corners[2]};
        near_[slot_[receiver]] = near_mean / patch_shelter(to.exposure);
    } else {
        received_[slot_[receiver]] = {form, near * share_out_near(facing_[slot_[receiver]], near)};
    }
}

}  // namespace gg
