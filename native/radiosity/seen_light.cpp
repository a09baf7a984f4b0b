#include "radiosity/seen_light.h"

namespace gg {

SeenLight::SeenLight(const Hierarchy& hierarchy, const Lighting& lighting)
    : hierarchy_(&hierarchy), lighting_(&lighting), elements_(find_elements(hierarchy)) {
    const Scene& scene = hierarchy.scene();
    const auto parts = parts_of_instances(hierarchy);
    clusters_.resize(parts.size());
    for (std::uint32_t i = 0; i < parts.size(); ++i) {
        for (const NodeId leaf : parts[i].leaf_clusters) {
            clusters_[i].resize(scene.meshes[scene.instances[i].mesh].triangles.size(), kNone);
            for_each_triangle_in(hierarchy, leaf, i, [&](std::uint32_t triangle) { clusters_[i][triangle] = leaf; });
        }
    }
}

Rgb SeenLight::radiosity(const Ray& ray, const Hit& hit) const {
    const Scene& scene = hierarchy_->scene();
    if (hit.missed()) {
        return kPi * scene.world;
    }
    const bool back = dot(world_area_vector(scene, hit.instance, hit.triangle), ray.direction) > 0;
    const NodeId element = elements_.of(hit.instance, hit.triangle, back);
    if (element != kNone) {
        return lighting_->radiosity(lighting_->leaf_element_at(element, ray.origin + hit.distance * ray.direction));
    }
    const auto& clusters = clusters_[hit.instance];
    const NodeId cluster = clusters.empty() ? kNone : clusters[hit.triangle];
    return cluster == kNone ? Rgb(0.0F) : lighting_->radiosity(cluster);
}

}  // namespace gg
