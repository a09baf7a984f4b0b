#include "radiosity/leaf_cluster.h"

namespace gg {

LeafCluster make_leaf_cluster(const Hierarchy& hierarchy, const Node& node) {
    const Scene& scene = hierarchy.scene();
    const SceneFaces& faces = hierarchy.faces();
    LeafCluster leaf;
    hierarchy.for_each_triangle(node, [&](std::uint32_t instance, std::uint32_t triangle) {
        const FaceColors& colors = faces.colors[faces.instance_colors[instance]];
        const Vec3 area_vector = world_area_vector(scene, instance, triangle);
        const float area = length(area_vector);
        if (!(area > 0)) {
            return;
        }
        const Vec3 normal = area_vector / area;
        const Exposure& exposure = faces.meshes[scene.instances[instance].mesh].exposure[triangle];
        for (const bool back : {false, true}) {
            const float exposed = back ? exposure.back : exposure.front;
            if (exposed <= 0) {
                continue;
            }
            const Vec3 outward = back ? -normal : normal;
            leaf.area += exposed * area;
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
