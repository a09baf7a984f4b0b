// Light that surfaces see by rays of their own. Links know a cluster only as a whole, and of elements each is a little
// wrong: so groups of a cluster's faces and elements look around themselves once more, and replace or correct what
// links tell of them.
#pragma once

#include <cstdint>
#include <vector>

#include "core/vec.h"
#include "radiosity/instance_parts.h"

namespace gg {

class Control;
class Lighting;
class RayTracer;

class GatheredLight {
  public:
    // Mean irradiance of a place, W/m2; the number of its rays, and the variance of the luminance that one brings.
    struct Estimate {
        Rgb irradiance{0.0F};
        float variance = 0;
        std::uint32_t rays = 0;
    };

    GatheredLight() = default;

    // Traces all rays: about `rays` from a group or an element of the size of a detail, and shadow rays to
    // lamps. Groups begin with what their cluster's links tell. The hierarchy must outlive this, unchanged.
    GatheredLight(const Hierarchy& hierarchy, const ElementTable& elements, const Lighting& lighting,
                  const RayTracer& tracer, int rays, const Control& control);

    // One Jacobi step: what the hit elements, in `lighting`, and the hit groups have now.
    void gather(const Lighting& lighting, const Control& control);
    // Tells `lighting` what the leaf clusters get and reflect by the sum of their faces.
    void tell(Lighting& lighting, const Control& control) const;
    // Corrects the elements of `lighting` by what their rays brought when light was gathered last.
    void correct(Lighting& lighting, const Control& control) const;
    // Frees what only the functions above need.
    void finish();

    // Mean irradiance of the group that a side of a triangle belongs to, W/m2; the triangle must be in a cluster.
    [[nodiscard]] Rgb irradiance(std::uint32_t instance, std::uint32_t triangle, bool back) const {
        return irradiance_[first_[instance] + groups_of(instance).of(triangle, back)];
    }
    [[nodiscard]] std::size_t count() const { return irradiance_.size(); }
    [[nodiscard]] std::size_t bytes() const;

  private:
    // A group with at least one face in a cluster, or a leaf element.
    struct Place {
        std::uint32_t instance = 0, group = 0;
        NodeId element = kNone;
        std::uint32_t rays = 0;
        std::size_t first_ray = 0;
    };
    // The faces of a group in one leaf cluster.
    struct Share {
        std::uint32_t group = 0;  // in irradiance_
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
    // What the rays of a place bring from an element: not what shadow rays bring, or links.
    [[nodiscard]] Rgb sent_by(NodeId element, bool to_element, const Lighting& lighting) const;
    void find_emitters();
    void find_groups(const Lighting& lighting, int rays, const Control& control);
    void list_groups(std::uint32_t instance, const InstanceParts& parts, const Lighting& lighting, int rays,
                     std::vector<Place>& out);
    void list_elements(int rays);
    [[nodiscard]] float detail() const;
    void list_shares(const Control& control);
    static void merge_shares(std::vector<Share>& list);
    [[nodiscard]] Estimate from_surfaces(std::size_t place, const Lighting& lighting) const;
    void trace(std::size_t begin, std::size_t end, const ElementTable& elements, const Lighting& lighting,
               const RayTracer& tracer);

    const Hierarchy* hierarchy_ = nullptr;
    std::vector<std::uint32_t> first_;  // instance -> its first group in irradiance_, or kNone
    std::vector<Rgb> irradiance_;       // per group
    std::vector<Rgb> reflectance_;      // per group, mean
    std::vector<NodeId> emitters_;      // elements of whole triangles; none when there are too many
    std::vector<Place> places_;         // groups, then elements
    std::size_t first_element_ = 0;
    std::vector<NodeId> elements_;     // of places_, from first_element_ on
    std::vector<Rgb> direct_;          // per element of elements_: what links bring of lamps and glowing surfaces
    std::vector<Estimate> estimates_;  // per element of elements_: of all other light
    std::vector<Rgb> constant_;        // per place: from lamps and sky
    std::vector<Rgb> glow_;            // per place: from glowing faces of clusters
    // Per ray: what it hit, a group as in irradiance_ or, with kElementBit, a leaf element; or kNone.
    std::vector<std::uint32_t> hits_;
    std::vector<NodeId> leaves_;          // leaf clusters
    std::vector<std::size_t> share_end_;  // of each of them in shares_
    std::vector<Share> shares_;
};

}  // namespace gg
