#include "radiosity/face_sampling.h"

#include <algorithm>

#include "core/random.h"
#include "radiosity/quarter.h"

namespace gg {

Vec3 sample_patch(const PatchForest& forest, std::uint32_t patch, std::array<Vec3, 3> corners, float u, Vec3 weights) {
    while (forest.is_open(patch)) {
        const Patch* quarters = &forest.patches[forest.patches[patch].first_child];
        float target = u * kQuarters * forest.patches[patch].exposure;
        int quarter = 0;
        while (quarter < kQuarters - 1 && !(target < quarters[quarter].exposure)) {
            target -= quarters[quarter].exposure;
            ++quarter;
        }
        u = quarters[quarter].exposure > 0 ? std::min(target / quarters[quarter].exposure, 1 - 0x1p-24F) : 0;
        patch = forest.patches[patch].first_child + quarter;
        corners = quarter_of(corners, quarter);
    }
    return weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2];
}

FacePoint sample_face(const Hierarchy& hierarchy, const Node& node, Spread spread, float u, float v, float w) {
    const Vec3 weights = square_to_triangle(v, w);
    const bool by_exposure = spread == Spread::kByExposure;
    if (node.kind == NodeKind::kElement) {
        const std::uint32_t patch = by_exposure ? node.patch : kNone;
        return {sample_patch(hierarchy.faces().patches, patch, node.corner, u, weights), node.normal, 1, 0};
    }
    const SceneFaces& faces = hierarchy.faces();
    const Scene& scene = hierarchy.scene();
    const ClusterTree::Node& range = hierarchy.tree_node(node);
    std::uint32_t instance = node.instance;
    std::uint32_t begin = range.begin, end = range.end;
    if (node.kind == NodeKind::kInstances) {
        const std::vector<double>& prefix = by_exposure ? faces.instance_exposed_prefix : faces.instance_prefix;
        const std::uint32_t item = sample_prefix(prefix, begin, end, u);
        instance = faces.instance_ids[faces.instances.order[item]];
        const double share = prefix[item + 1] - prefix[item];
        const double target = prefix[begin] + u * (prefix[end] - prefix[begin]);
        u = share > 0 ? static_cast<float>((target - prefix[item]) / share) : 0.5F;
        begin = 0;
        end = static_cast<std::uint32_t>(scene.meshes[scene.instances[instance].mesh].triangles.size());
    }
    const MeshFaces& mesh = faces.meshes[scene.instances[instance].mesh];
    const std::vector<double>& prefix = by_exposure ? mesh.exposed_prefix : mesh.area_prefix;
    const std::uint32_t triangle = mesh.tree.order[sample_prefix(prefix, begin, end, u)];
    const auto corner = world_triangle(scene, instance, triangle);
    const Vec3 front = normalize_or_zero(world_area_vector(scene, instance, triangle));
    const Exposure& exposure = mesh.exposure[triangle];
    const float front_share = by_exposure ? exposure.front / exposure.sum()
                                          : (exposure.front > 0 ? 1.0F : 0.0F) / static_cast<float>(exposure.sides());
    return {weights.x * corner[0] + weights.y * corner[1] + weights.z * corner[2], front, front_share, 1 - front_share};
}

}  // namespace gg
