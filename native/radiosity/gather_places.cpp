// GatheredLight: who gathers, and who is told.
#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "radiosity/gathered_light.h"
#include "radiosity/lighting.h"
#include "radiosity/reference_white.h"

namespace gg {

namespace {

constexpr float kCovered = 0.1F;  // exposure
// Of a group, as shares of the rays of one of the size of a detail; small ones have many neighbours.
constexpr float kLeastShare = 0.25F, kMostShare = 64;
constexpr float kLeastRays = 2;
constexpr float kLeastElementRays = 6, kMostElementRays = 512;
// Share of the rays of an element of the size of a detail that one so long has, however thin it is.
constexpr float kThin = 0.25F;
constexpr float kMostBright = 8;       // times the rays, of places that are brighter than the reference white
constexpr float kMoreWithSky = 2;      // few rays find windows, and the patches of sunlight behind them
constexpr float kDetail = 1.0F / 200;  // size of a place, as a share of the scene's, from which all rays start

// What is brighter than most lights its surroundings, and its noise does, too. Both: W/m2.
float more_where_bright(Rgb irradiance, float white) {
    return std::clamp(luminance(irradiance) / white, 1.0F, kMostBright);
}

}  // namespace

// Lists the groups and gives each what its cluster's links tell.
void GatheredLight::find_groups(const Lighting& lighting, float white, int rays, const Control& control) {
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
    places_ = parallel_collect<Place>(parts.size(), 1, control,
                                      [&](std::size_t begin, std::size_t end, std::vector<Place>& out) {
                                          for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
                                              list_groups(i, parts[i], lighting, white, rays, out);
                                          }
                                      });
    place_of_group_.assign(total, kNone);
    radiosity_.reserve(places_.size());
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const Rgb irradiance = irradiance_[first_[places_[i].instance] + places_[i].group];
        place_of_group_[first_[places_[i].instance] + places_[i].group] = static_cast<std::uint32_t>(i);
        radiosity_.push_back(places_[i].reflectance * irradiance);
    }
}

void GatheredLight::list_groups(std::uint32_t instance, const InstanceParts& parts, const Lighting& lighting,
                                float white, int rays, std::vector<Place>& out) {
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
        // What is covered has next to no light.
        const FaceSide& first = groups[g].front();
        const Exposure& exposure = mesh.exposure[first.triangle];
        const bool covered = (first.back ? exposure.back : exposure.front) < kCovered;
        const float size = std::sqrt(area) / detail();
        const float share =
            covered ? 0.0F : std::clamp(std::max(std::min(1.0F, size), size * size), kLeastShare, kMostShare);
        const auto count = static_cast<std::uint32_t>(more_where_bright(inverse * arriving, white) *
                                                      std::max(kLeastRays, static_cast<float>(rays) * share));
        out.push_back({instance, g, cluster[g], kNone, count, 0, 1, area, inverse * reflecting});
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
    list.shrink_to_fit();  // it had an entry for every face
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

void GatheredLight::list_elements(const Lighting& lighting, float white, int rays) {
    first_element_ = places_.size();
    place_of_element_.assign(hierarchy_->nodes().size(), kNone);
    std::vector<NodeId> leaves;
    for (NodeId id = 0; id < hierarchy_->nodes().size(); ++id) {
        if ((*hierarchy_)[id].kind == NodeKind::kElement && (*hierarchy_)[id].child_count == 0) {
            leaves.push_back(id);
        }
    }
    const float more = luminance(hierarchy_->scene().world) > 0 ? kMoreWithSky : 1.0F;
    places_.reserve(places_.size() + leaves.size());
    radiosity_.reserve(places_.size() + leaves.size());
    for (const NodeId id : leaves) {
        const Node& node = (*hierarchy_)[id];
        const float length = kThin * 2 * node.radius / detail();
        const float share = std::max(length, node.area / (detail() * detail()));
        const auto count = static_cast<std::uint32_t>(
            more * more_where_bright(lighting.irradiance(id), white) *
            std::clamp(static_cast<float>(rays) * share, kLeastElementRays, kMostElementRays));
        place_of_element_[id] = static_cast<std::uint32_t>(places_.size());
        places_.push_back({node.instance, kNone, kNone, id, count, 0, 1, node.area, node.reflectance});
        radiosity_.push_back(node.reflectance * lighting.irradiance(id));
    }
    of_elements_ = ElementOpinions(*hierarchy_, leaves);
}

float GatheredLight::detail() const {
    return kDetail * 2 * (*hierarchy_)[kGeometryRoot].radius;
}

}  // namespace gg
