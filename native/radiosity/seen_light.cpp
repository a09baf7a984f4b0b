#include "radiosity/seen_light.h"

namespace gg {

SeenLight::SeenLight(const Hierarchy& hierarchy, const Lighting& lighting)
    : hierarchy_(&hierarchy),
      lighting_(&lighting),
      elements_(find_elements(hierarchy)),
      clusters_(find_clusters(hierarchy)) {}

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
    const NodeId cluster = clusters_.of(hit.instance, hit.triangle);
    return cluster == kNone ? Rgb(0.0F) : lighting_->radiosity(cluster);
}

}  // namespace gg
