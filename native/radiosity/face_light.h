// Light on the faces that stayed in clusters. Links know only the cluster as a whole, so its faces look around
// themselves: rays from groups of faces bring the radiosity of what they hit.
#pragma once

#include <cstdint>
#include <vector>

#include "core/vec.h"
#include "radiosity/instance_parts.h"

namespace gg {

class Control;
class Lighting;
class RayTracer;

class FaceLight {
  public:
    FaceLight() = default;

    // Traces all rays: about `rays` from a group of the size of a detail, and shadow rays to lamps. Every group begins
    // with what its cluster's links tell. The hierarchy must outlive this, unchanged.
    FaceLight(const Hierarchy& hierarchy, const ElementTable& elements, const Lighting& lighting,
              const RayTracer& tracer, int rays, const Control& control);

    // One Jacobi step: what the hit elements, in `lighting`, and the hit groups have now.
    void gather(const Lighting& lighting, const Control& control);
    // Tells `lighting` what the leaf clusters get and reflect by the sum of their faces.
    void tell(Lighting& lighting, const Control& control) const;
    // Luminance of what comes to the faces from elements and other faces, W.
    [[nodiscard]] double power_from_surfaces(const Lighting& lighting) const;
    // Frees what only the functions above need.
    void finish();

    // Mean irradiance of the group that a side of a triangle belongs to, W/m2; the triangle must be in a cluster.
    [[nodiscard]] Rgb irradiance(std::uint32_t instance, std::uint32_t triangle, bool back) const {
        return irradiance_[first_[instance] + groups_of(instance).of(triangle, back)];
    }
    [[nodiscard]] std::size_t count() const { return irradiance_.size(); }
    [[nodiscard]] std::size_t bytes() const;

  private:
    // A group of an instance with at least one face in a cluster.
    struct Group {
        std::uint32_t instance = 0, group = 0;
        float area = 0;  // of all its faces, m2
        std::uint32_t rays = 0;
        std::size_t first_ray = 0;
    };
    // The faces of a group in one leaf cluster.
    struct Share {
        std::uint32_t place = 0;  // in irradiance_
        Vec3 facing{0.0F};        // sum of area times normal, m2
        float area = 0;           // m2
        Rgb reflecting{0.0F};     // area times reflectance
    };
    class Block;
    static constexpr std::uint32_t kElementBit = 0x80000000U;  // of hits_

    [[nodiscard]] const FaceGroups& groups_of(std::uint32_t instance) const {
        const Scene& scene = hierarchy_->scene();
        return hierarchy_->faces().meshes[scene.instances[instance].mesh].groups;
    }
    [[nodiscard]] const FaceColors& colors_of(std::uint32_t instance) const {
        return hierarchy_->faces().colors[hierarchy_->faces().instance_colors[instance]];
    }
    void find_groups(const Lighting& lighting, int rays, const Control& control);
    void list_groups(std::uint32_t instance, const InstanceParts& parts, const Lighting& lighting, int rays,
                     std::vector<Group>& out);
    void list_shares(const Control& control);
    static void merge_shares(std::vector<Share>& list);
    [[nodiscard]] Rgb from_surfaces(std::size_t group, const Lighting& lighting) const;
    void trace(std::size_t begin, std::size_t end, const ElementTable& elements, const Lighting& lighting,
               const RayTracer& tracer);

    const Hierarchy* hierarchy_ = nullptr;
    std::vector<std::uint32_t> first_;  // instance -> place of its first group, or kNone
    std::vector<Rgb> irradiance_;       // per place
    std::vector<Rgb> reflectance_;      // per place, mean
    std::vector<Group> groups_;
    std::vector<Rgb> constant_;  // per group of groups_: from lamps and sky
    std::vector<Rgb> glow_;      // per group of groups_: from glowing faces of clusters
    std::vector<std::uint32_t>
        hits_;                    // per ray: the place or, with kElementBit, the leaf element that it hit; or kNone
    std::vector<NodeId> leaves_;  // leaf clusters
    std::vector<std::size_t> share_end_;  // of each of them in shares_
    std::vector<Share> shares_;
};

}  // namespace gg
