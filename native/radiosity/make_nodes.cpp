// Hierarchy: nodes of every kind, from the scene.
#include <algorithm>

#include "core/random.h"
#include "material/surface_color.h"
#include "radiosity/hierarchy.h"
#include "radiosity/quarter.h"

namespace gg {

namespace {

constexpr std::uint64_t kGroupSeed = 0x67656f6d, kLampSeed = 0x6c616d70;

void set_bounds(Node& node, const Box& box) {
    node.corner[0] = box.lower;
    node.corner[1] = box.upper;
    node.center = box.center();
    node.radius = 0.5F * box.diameter();
}

void set_triangle(Node& node) {
    const auto& c = node.corner;
    node.center = (c[0] + c[1] + c[2]) / 3.0F;
    node.radius = std::sqrt(std::max(
        {length_squared(c[0] - node.center), length_squared(c[1] - node.center), length_squared(c[2] - node.center)}));
}

float mean_exposure(const std::vector<double>& area, const std::vector<double>& exposed,
                    const ClusterTree::Node& range) {
    const double whole = area[range.end] - area[range.begin];
    return whole > 0 ? static_cast<float>((exposed[range.end] - exposed[range.begin]) / whole) : 1.0F;
}

int lit_sides(Sides sides) {
    return sides == Sides::kBoth ? 2 : 1;
}

}  // namespace

Node Hierarchy::make_instances(std::uint32_t tree_node, NodeId parent) const {
    const ClusterTree::Node& range = faces_.instances.nodes[tree_node];
    if (parent != kNone && range.end == range.begin + 1) {
        return make_cluster(faces_.instance_ids[faces_.instances.order[range.begin]], 0, parent);
    }
    Node node;
    node.kind = NodeKind::kInstances;
    node.parent = parent;
    node.source = tree_node;
    set_bounds(node, range.bounds);
    glm::dvec3 reflected(0.0), emitted(0.0);
    double area = 0;
    std::uint64_t ids = 0;
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
        const std::uint32_t instance = faces_.instance_ids[faces_.instances.order[i]];
        const Node cluster = make_cluster(instance, 0, parent);
        area += cluster.area;
        reflected += static_cast<double>(cluster.area) * glm::dvec3(cluster.reflectance);
        emitted += static_cast<double>(cluster.area) * glm::dvec3(cluster.emission);
        ids += hash64(scene_.instances[instance].stable_id);
    }
    node.area = static_cast<float>(area);
    node.exposure = mean_exposure(faces_.instance_prefix, faces_.instance_exposed_prefix, range);
    node.reflectance = Rgb(reflected / std::max(area, 1e-300));
    node.emission = Rgb(emitted / std::max(area, 1e-300));
    node.stable_id = hash64(ids, kGroupSeed);
    return node;
}

Node Hierarchy::make_cluster(std::uint32_t instance, std::uint32_t tree_node, NodeId parent) const {
    const Instance& placed = scene_.instances[instance];
    const MeshFaces& mesh = faces_.meshes[placed.mesh];
    const FaceColors& colors = faces_.colors[faces_.instance_colors[instance]];
    const ClusterTree::Node& range = mesh.tree.nodes[tree_node];
    if (tree_node == 0 && range.end == range.begin) {
        return {};
    }
    Node node;
    node.kind = NodeKind::kCluster;
    node.parent = parent;
    node.instance = instance;
    node.source = tree_node;
    set_bounds(node, tree_node == 0 ? placed.bounds : transformed(range.bounds, placed.to_world));
    const double scale = faces_.instance_area[instance] / std::max(mesh.area, 1e-300);  // object to world area
    const double area = scale * (mesh.area_prefix[range.end] - mesh.area_prefix[range.begin]);
    node.area = static_cast<float>(area);
    node.exposure = mean_exposure(mesh.area_prefix, mesh.exposed_prefix, range);
    node.reflectance = colors.mean_reflectance;
    if (!colors.emission_prefix.empty() && area > 0) {
        const double emitted = scale * (colors.emission_prefix[range.end] - colors.emission_prefix[range.begin]);
        const double sides = lit_sides(scene_.sides_of(instance, mesh.tree.order[range.begin]));
        node.emission = Rgb(static_cast<float>(kPi * emitted * sides / area));
    }
    node.stable_id = hash64(placed.stable_id, tree_node);
    return node;
}

Node Hierarchy::make_element(std::uint32_t instance, std::uint32_t triangle, bool back, NodeId parent) const {
    const FaceColors& colors = faces_.colors[faces_.instance_colors[instance]];
    Node node;
    node.kind = NodeKind::kElement;
    node.back = back;
    node.parent = parent;
    node.instance = instance;
    node.source = triangle;
    node.corner = world_triangle(scene_, instance, triangle);
    node.weights[1] = {1, 0};
    node.weights[2] = {0, 1};
    set_triangle(node);
    const Vec3 area = world_area_vector(scene_, instance, triangle);
    node.area = length(area);
    node.normal = normalize_or_zero(back ? -area : area);
    node.reflectance = colors.reflectance[triangle];
    if (!colors.emission.empty()) {
        node.emission = kPi * colors.emission[triangle];
    }
    node.stable_id = hash64(hash64(scene_.instances[instance].stable_id, triangle), back ? 2 : 1);
    const Exposure& exposure = faces_.meshes[scene_.instances[instance].mesh].exposure[triangle];
    node.weight = back ? exposure.back : exposure.front;
    node.shelter = back ? exposure.back_shelter : exposure.front_shelter;
    node.patch = faces_.patches.root(instance, triangle, back);
    if (node.patch != kNone) {
        const Patch& patch = faces_.patches.patches[node.patch];
        node.exposure = patch.exposure;
        node.weight /= patch.exposure;  // its patches have the rest
    }
    return node;
}

Node Hierarchy::make_quarter(NodeId parent, int quarter) const {
    const Node& whole = nodes_[parent];
    Node node = whole;
    node.parent = parent;
    node.child_count = 0;
    node.first_child = 0;
    node.depth = static_cast<std::uint8_t>(whole.depth + 1);
    node.area = 0.25F * whole.area;
    node.exposure = 1;
    node.weight = 1;
    node.patch = kNone;
    if (whole.patch != kNone) {
        const std::uint32_t id = faces_.patches.patches[whole.patch].first_child + quarter;
        const Patch& patch = faces_.patches.patches[id];
        if (faces_.patches.is_open(id)) {
            node.patch = id;
            node.exposure = patch.exposure;
        } else {
            node.weight = patch.exposure;
        }
    }
    node.stable_id = hash64(whole.stable_id, 3 + quarter);
    node.corner = quarter_of(whole.corner, quarter);
    node.weights = quarter_of(whole.weights, quarter);
    set_triangle(node);
    const std::uint32_t material = scene_.material_of(whole.instance, whole.source);
    const Mesh& mesh = scene_.meshes[scene_.instances[whole.instance].mesh];
    if (colors_.is_textured(material) && !mesh.uvs.empty()) {
        const Vec2* uv = &mesh.uvs[3 * static_cast<std::size_t>(whole.source)];
        Vec2 at[3];
        for (int k = 0; k < 3; ++k) {
            at[k] = uv[0] + node.weights[k].x * (uv[1] - uv[0]) + node.weights[k].y * (uv[2] - uv[0]);
        }
        node.reflectance = colors_.mean_reflectance(material, at[0], at[1], at[2]);
        if (colors_.emits(material)) {
            node.emission = kPi * colors_.mean_emission(material, at[0], at[1], at[2]);
        }
    }
    return node;
}

// Radiosity of a lamp is what times a form factor gives irradiance: pi L of a surface, the intensity of a point (its
// form factor is 1 / d^2), the irradiance of a distant lamp (its form factor is the cosine).
Node Hierarchy::make_lamp(std::uint32_t lamp) const {
    const Lamp& source = scene_.lamps[lamp];
    Node node;
    node.kind = NodeKind::kLamp;
    node.source = lamp;
    node.center = source.shape == LampShape::kDistant ? -source.direction : source.position;
    node.radius = source.shape == LampShape::kSphere
                      ? source.radius
                      : std::sqrt(length_squared(source.half_x) + length_squared(source.half_y));
    node.emission = source.shape == LampShape::kDistant ? source.irradiance
                    : source.shape == LampShape::kPoint ? source.radiance
                                                        : kPi * source.radiance;
    node.stable_id = hash64(kLampSeed, source.stable_id);
    return node;
}

Node Hierarchy::make_sky(SkyCell cell, NodeId parent, std::uint64_t stable_id) const {
    Node node;
    node.kind = NodeKind::kSky;
    node.back = cell.face != 0;
    node.depth = cell.level;
    node.parent = parent;
    node.source = static_cast<std::uint32_t>(cell.i) << 16 | cell.j;
    node.center = cell_direction(cell, 0.5F, 0.5F);
    node.area = cell_solid_angle(cell);
    node.radius = std::sqrt(node.area / kPi);
    node.emission = kPi * scene_.world;
    node.stable_id = stable_id;
    return node;
}

}  // namespace gg
