#include "radiosity/face_sampling.h"

#include "core/random.h"

namespace gg {

FacePoint sample_face(const Hierarchy& hierarchy, const Node& node, float u, float v, float w) {
    const Vec3 weights = square_to_triangle(v, w);
    if (node.kind == NodeKind::kElement) {
        return {weights.x * node.corner[0] + weights.y * node.corner[1] + weights.z * node.corner[2], node.normal, 1,
                0};
    }
    const SceneFaces& faces = hierarchy.faces();
    const Scene& scene = hierarchy.scene();
    const ClusterTree::Node& range = hierarchy.tree_node(node);
    std::uint32_t instance = node.instance;
    std::uint32_t begin = range.begin, end = range.end;
    if (node.kind == NodeKind::kInstances) {
        const std::uint32_t item = sample_prefix(faces.instance_prefix, begin, end, u);
        instance = faces.instance_ids[faces.instances.order[item]];
        const double share = faces.instance_prefix[item + 1] - faces.instance_prefix[item];
        const double target =
            faces.instance_prefix[begin] + u * (faces.instance_prefix[end] - faces.instance_prefix[begin]);
        u = share > 0 ? static_cast<float>((target - faces.instance_prefix[item]) / share) : 0.5F;
        begin = 0;
        end = static_cast<std::uint32_t>(scene.meshes[scene.instances[instance].mesh].triangles.size());
    }
    const MeshFaces& mesh = faces.meshes[scene.instances[instance].mesh];
    const std::uint32_t triangle = mesh.tree.order[sample_prefix(mesh.area_prefix, begin, end, u)];
    const auto corner = world_triangle(scene, instance, triangle);
    const Vec3 front = normalize_or_zero(world_area_vector(scene, instance, triangle));
    const Exposure& exposure = mesh.exposure[triangle];
    return {weights.x * corner[0] + weights.y * corner[1] + weights.z * corner[2], front,
            exposure.front / exposure.sum(), exposure.back / exposure.sum()};
}

}  // namespace gg
