#include "radiosity/face_light.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.h"
#include "radiosity/lighting.h"

namespace gg {

namespace {

constexpr float kSize = 1.0F / 128;  // of a group, as a share of the scene's, from which all rays start
constexpr std::size_t kGroupsAtOnce = 32;

}  // namespace

FaceLight::FaceLight(const Hierarchy& hierarchy, const ElementTable& elements, const Lighting& lighting,
                     const RayTracer& tracer, int rays, const Control& control)
    : hierarchy_(&hierarchy) {
    find_groups(lighting, rays, control);
    list_shares(control);
    constant_.assign(groups_.size(), Rgb(0.0F));
    glow_.assign(groups_.size(), Rgb(0.0F));
    hits_.assign(groups_.empty() ? 0 : groups_.back().first_ray + groups_.back().rays, kNone);
    parallel_blocks(groups_.size(), kGroupsAtOnce, control,
                    [&](std::size_t begin, std::size_t end) { trace(begin, end, elements, lighting, tracer); });
}

// Lists the groups and gives each what its cluster's links tell.
void FaceLight::find_groups(const Lighting& lighting, int rays, const Control& control) {
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
    groups_ = parallel_collect<Group>(parts.size(), 1, control,
                                      [&](std::size_t begin, std::size_t end, std::vector<Group>& out) {
                                          for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
                                              list_groups(i, parts[i], lighting, rays, out);
                                          }
                                      });
    for (std::size_t i = 1; i < groups_.size(); ++i) {
        groups_[i].first_ray = groups_[i - 1].first_ray + groups_[i - 1].rays;
    }
}

void FaceLight::list_groups(std::uint32_t instance, const InstanceParts& parts, const Lighting& lighting, int rays,
                            std::vector<Group>& out) {
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
    const float detail = kSize * 2 * (*hierarchy_)[kGeometryRoot].radius;
    const auto whole = static_cast<float>(rays);
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
        // Small groups have many neighbours.
        const float count = std::clamp(whole * std::sqrt(area) / detail, 0.25F * whole, 2 * whole);
        out.push_back({instance, g, area, static_cast<std::uint32_t>(count), 0});
    }
}

// One share for every group, in their order.
void FaceLight::merge_shares(std::vector<Share>& list) {
    std::stable_sort(list.begin(), list.end(), [](const Share& a, const Share& b) { return a.place < b.place; });
    std::size_t last = 0;
    for (std::size_t i = 1; i < list.size(); ++i) {
        if (list[i].place == list[last].place) {
            list[last].facing += list[i].facing;
            list[last].area += list[i].area;
            list[last].reflecting += list[i].reflecting;
        } else {
            list[++last] = list[i];
        }
    }
    list.resize(list.empty() ? 0 : last + 1);
}

void FaceLight::list_shares(const Control& control) {
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

// Mean of what the rays of a group bring from surfaces.
Rgb FaceLight::from_surfaces(std::size_t i, const Lighting& lighting) const {
    const Group& group = groups_[i];
    Rgb sum(0.0F);
    for (std::size_t k = group.first_ray; k < group.first_ray + group.rays; ++k) {
        const std::uint32_t hit = hits_[k];
        if (hit != kNone) {
            sum += hit & kElementBit ? lighting.radiosity(hit & ~kElementBit) : reflectance_[hit] * irradiance_[hit];
        }
    }
    return glow_[i] + sum / static_cast<float>(group.rays);
}

void FaceLight::gather(const Lighting& lighting, const Control& control) {
    std::vector<Rgb> next = irradiance_;
    parallel_for(groups_.size(), 1024, control, [&](std::size_t i) {
        next[first_[groups_[i].instance] + groups_[i].group] = constant_[i] + from_surfaces(i, lighting);
    });
    irradiance_ = std::move(next);
}

double FaceLight::power_from_surfaces(const Lighting& lighting) const {
    double power = 0;
    for (std::size_t i = 0; i < groups_.size(); ++i) {
        power += groups_[i].area * luminance(from_surfaces(i, lighting));
    }
    return power;
}

void FaceLight::tell(Lighting& lighting, const Control& control) const {
    parallel_for(leaves_.size(), 8, control, [&](std::size_t i) {
        Rgb arriving(0.0F), reflected(0.0F);
        DirectionalForm intensity;
        for (std::size_t k = i > 0 ? share_end_[i - 1] : 0; k < share_end_[i]; ++k) {
            const Share& share = shares_[k];
            const Rgb irradiance = irradiance_[share.place];
            arriving += share.area * irradiance;
            reflected += share.reflecting * irradiance;
            add_face(intensity, share.reflecting * irradiance / kPi, normalize_or_zero(share.facing));
        }
        lighting.set_faces_of(leaves_[i], arriving, reflected, intensity);
    });
}

void FaceLight::finish() {
    groups_ = {};
    constant_ = {};
    glow_ = {};
    hits_ = {};
    reflectance_ = {};
    leaves_ = {};
    share_end_ = {};
    shares_ = {};
}

std::size_t FaceLight::bytes() const {
    return (irradiance_.capacity() + reflectance_.capacity() + constant_.capacity()) * sizeof(Rgb) +
           (first_.capacity() + hits_.capacity()) * sizeof(std::uint32_t) + groups_.capacity() * sizeof(Group) +
           shares_.capacity() * sizeof(Share);
}

}  // namespace gg
