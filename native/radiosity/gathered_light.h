// Light that surfaces see by rays of their own. Links know a cluster only as a whole, and each is a little wrong in its
// own way: so groups of a cluster's faces and leaf elements, the places, look around themselves once more, and light
// comes to rest between them anew. What a ray brings is at most what is there, so this never diverges.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"
#include "radiosity/instance_parts.h"
#include "radiosity/opinions.h"
#include "radiosity/source_guide.h"

namespace gg {

class Control;
class Lighting;
class RayTracer;

class GatheredLight {
  public:
    GatheredLight() = default;

    // Traces all rays: about `rays` from a place of the size of a detail, and shadow rays to what the guide lists.
    // Places begin with what links, as `lighting` has gathered them, tell; emitted_by_links [W/m2], per node: so much
    // of it comes from lamps, sky and glowing surfaces. The hierarchy must outlive this, unchanged; the guide until
    // finish().
    GatheredLight(const Hierarchy& hierarchy, const ElementTable& elements, const SourceGuide& guide,
                  const Lighting& lighting, std::span<const Rgb> emitted_by_links, const RayTracer& tracer, int rays,
                  const Control& control);

    // Lets light come to rest between the places. Returns the number of iterations.
    int settle(int most, double converged, const Control& control);
    // Tells `lighting` what leaf clusters and leaf elements have.
    void tell(Lighting& lighting, const Control& control);
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
        NodeId cluster = kNone;  // of a group: a leaf cluster that has faces of it
        NodeId element = kNone;
        std::uint32_t rays = 0;  // from points that are not covered
        std::size_t first_ray = 0;
        float open = 1;  // share of the points that are not covered
        float area = 0;  // m2
        Rgb reflectance{0.0F};
    };
    // The faces of a group in one leaf cluster.
    struct Share {
        std::uint32_t group = 0;  // in irradiance_
        Vec3 facing{0.0F};        // sum of area times normal, m2
        float area = 0;           // m2
        Rgb reflecting{0.0F};     // area times reflectance
    };
    class Block;

    [[nodiscard]] const FaceGroups& groups_of(std::uint32_t instance) const {
        const Scene& scene = hierarchy_->scene();
        return hierarchy_->faces().meshes[scene.instances[instance].mesh].groups;
    }
    [[nodiscard]] const FaceColors& colors_of(std::uint32_t instance) const {
        return hierarchy_->faces().colors[hierarchy_->faces().instance_colors[instance]];
    }
    void find_groups(const Lighting& lighting, float white, int rays, const Control& control);
    void list_groups(std::uint32_t instance, const InstanceParts& parts, const Lighting& lighting, float white,
                     int rays, std::vector<Place>& out);
    void list_elements(const Lighting& lighting, float white, int rays);
    [[nodiscard]] float detail() const;
    void list_shares(const Control& control);
    static void merge_shares(std::vector<Share>& list);
    [[nodiscard]] Rgb reflected_to(std::size_t place) const;
    double iterate(const Control& control);
    void trace(std::size_t begin, std::size_t end, const ElementTable& elements, const Lighting& lighting,
               const RayTracer& tracer);

    const Hierarchy* hierarchy_ = nullptr;
    std::vector<std::uint32_t> first_;  // instance -> its first group in irradiance_, or kNone
    std::vector<Rgb> irradiance_;       // per group
    const SourceGuide* guide_ = nullptr;
    std::vector<Place> places_;  // groups, then elements
    std::size_t first_element_ = 0;
    std::vector<std::uint32_t> place_of_group_;    // as in irradiance_
    std::vector<std::uint32_t> place_of_element_;  // per node
    std::vector<Rgb> emitted_;                     // per place: irradiance from lamps, sky, glowing surfaces
    std::vector<Rgb> light_;                       // per place: all irradiance
    std::vector<Opinions> opinions_;               // per leaf element: of reflected light
    ElementOpinions of_elements_;
    std::vector<Rgb> radiosity_;          // per place, without what it emits
    std::vector<std::uint32_t> hits_;     // per ray: the place that it hit, or kNone
    std::vector<NodeId> leaves_;          // leaf clusters
    std::vector<std::size_t> share_end_;  // of each of them in shares_
    std::vector<Share> shares_;
};

}  // namespace gg
