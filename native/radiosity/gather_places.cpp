// GatheredLight: who gathers, and who is told.
#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "radiosity/gathered_light.h"
#include "radiosity/lighting.h"

namespace gg {

namespace {

constexpr float kCovered = 0.1F;  // exposure
constexpr float kLeastRays = 2;
constexpr float kMostRays = 16;        // of an element: it has links, too
constexpr float kDetail = 1.0F / 128;  // size of a group, as a share of the scene's, from which all rays start

}  // namespace

// Lists the groups and gives each what its cluster's links tell.
void GatheredLight::find_groups(const Lighting& lighting, int rays, const Control& control) {
    const auto parts = parts_of_instances(*hierarchy_);
    first_.assign(parts.size(), kNone);
    std::uint32_t total = 0;
    for (std::uint32_t i = 0; i < parts.size(); ++i) {
        if (!parts[i].leaf_clusters.empty()) {
            first_[i] = total;
            total += static_cast<std::uint32_t>(groups_of(i).count());
        }
    }
    irradiance_.assign(total, Rgb(0.0F));
    reflectance_.assign(total, Rgb(0.0F));
    places_ = parallel_collect<Place>(parts.size(), 1, control,
                                      [&](std::size_t begin, std::size_t end, std::vector<Place>& out) {
                                          for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
                                              list_groups(i, parts[i], lighting, rays, out);
                                          }
                                      });
}

void GatheredLight::list_groups(std::uint32_t instance, const InstanceParts& parts, const Lighting& lighting, int rays,
                                std::vector<Place>& out) {
    if (parts.leaf_clusters.empty()) {
        return;
    }
    const Scene& scene = hierarchy_->scene();
    const FaceGroups& groups = groups_of(instance);
    const MeshFaces& mesh = hierarchy_->faces().meshes[scene.instances[instance].mesh];
    std::vector<NodeId> cluster(groups.count(), kNone);
    for (const NodeId leaf : parts.leaf_clusters) {
        for_each_triangle_in(*hierarchy_, leaf, instance, [&](std::uint32_t triangle) {
            for (const std::uint32_t group : {groups.of_front[triangle], groups.of_back[triangle]}) {
                if (group != kNone) {
                    cluster[group] = leaf;
                }
            }
        });
    }
    for (std::uint32_t g = 0; g < cluster.size(); ++g) {
        if (cluster[g] == kNone) {
            continue;
        }
        Rgb reflecting(0.0F), arriving(0.0F);
        float area = 0;
        for (const FaceSide side : groups[g]) {
            const Vec3 vector = world_area_vector(scene, instance, side.triangle);
            const Vec3 normal = normalize_or_zero(side.back ? -vector : vector);
            const float face = length(vector);
            area += face;
            reflecting += face * colors_of(instance).reflectance[side.triangle];
            arriving += face * lighting.irradiance_of_face(cluster[g], mesh.exposure[side.triangle], side.back, normal);
        }
        const float inverse = 1 / std::max(area, 1e-30F);
        irradiance_[first_[instance] + g] = inverse * arriving;
        reflectance_[first_[instance] + g] = inverse * reflecting;
        // Small ones have many neighbours; covered ones have next to no light.
        const FaceSide& first = groups[g].front();
        const Exposure& exposure = mesh.exposure[first.triangle];
        const bool covered = (first.back ? exposure.back : exposure.front) < kCovered;
        const float share = covered ? 0.0F : std::clamp(std::sqrt(area) / detail(), 0.25F, 2.0F);
        const auto count = static_cast<std::uint32_t>(std::max(kLeastRays, static_cast<float>(rays) * share));
        out.push_back({instance, g, kNone, count, 0});
    }
}

// One share for every group, in their order.
void GatheredLight::merge_shares(std::vector<Share>& list) {
    std::stable_sort(list.begin(), list.end(), [](const Share& a, const Share& b) { return a.group < b.group; });
    std::size_t last = 0;
    for (std::size_t i = 1; i < list.size(); ++i) {
        if (list[i].group == list[last].group) {
            list[last].facing += list[i].facing;
            list[last].area += list[i].area;
            list[last].reflecting += list[i].reflecting;
        } else {
            list[++last] = list[i];
        }
    }
    list.resize(list.empty() ? 0 : last + 1);
}

void GatheredLight::list_shares(const Control& control) {
    const Scene& scene = hierarchy_->scene();
    for (NodeId id = 0; id < hierarchy_->nodes().size() && hierarchy_->has_geometry(); ++id) {
        if (is_cluster((*hierarchy_)[id]) && (*hierarchy_)[id].child_count == 0) {
            leaves_.push_back(id);
        }
    }
    std::vector<std::vector<Share>> lists(leaves_.size());
    parallel_for(leaves_.size(), 4, control, [&](std::size_t i) {
        std::vector<Share>& list = lists[i];
        hierarchy_->for_each_triangle((*hierarchy_)[leaves_[i]], [&](std::uint32_t instance, std::uint32_t triangle) {
            const Vec3 vector = world_area_vector(scene, instance, triangle);
            const float area = length(vector);
            for (const bool back : {false, true}) {
                const std::uint32_t group = groups_of(instance).of(triangle, back);
                if (group != kNone) {
                    list.push_back({first_[instance] + group, back ? -vector : vector, area,
                                    area * colors_of(instance).reflectance[triangle]});
                }
            }
        });
        merge_shares(list);
    });
    for (const auto& list : lists) {
        shares_.insert(shares_.end(), list.begin(), list.end());
        share_end_.push_back(shares_.size());
    }
}

void GatheredLight::list_elements(int rays) {
    first_element_ = places_.size();
    for (NodeId id = 0; id < hierarchy_->nodes().size(); ++id) {
        const Node& node = (*hierarchy_)[id];
        if (node.kind == NodeKind::kElement && node.child_count == 0) {
            // By area: the mean of a whole wall must be sure, its small parts have links.
            const float share = node.area / (detail() * detail());
            const auto count =
                static_cast<std::uint32_t>(std::clamp(static_cast<float>(rays) * share, kLeastRays, kMostRays));
            places_.push_back({node.instance, kNone, id, count, 0});
            elements_.push_back(id);
        }
    }
}

void GatheredLight::find_emitters() {
    constexpr std::size_t kMost = 256;     // every place looks at all of them
    constexpr double kLargest = 1.0 / 16;  // share of all area; rays find larger ones by themselves
    double area = 0, emitting = 0;
    for (NodeId id = 0; id < hierarchy_->nodes().size(); ++id) {
        const Node& node = (*hierarchy_)[id];
        if (is_surface(node) && node.child_count == 0) {
            area += node.area;
        }
        if (node.kind == NodeKind::kElement && node.depth == 0 && luminance(node.emission) > 0) {
            emitters_.push_back(id);
            emitting += node.area;
        }
    }
    if (emitters_.size() > kMost || emitting > kLargest * area) {
        emitters_.clear();
    }
}

float GatheredLight::detail() const {
    return kDetail * 2 * (*hierarchy_)[kGeometryRoot].radius;
}

}  // namespace gg
