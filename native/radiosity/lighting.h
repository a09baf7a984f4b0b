// The state of the light on an open hierarchy: gathering over links, pushing irradiance down, pulling radiosity up.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/vec.h"
#include "radiosity/hierarchy.h"
#include "radiosity/leaf_cluster.h"
#include "radiosity/link.h"
#include "transport/directional_form.h"

namespace gg {

class Control;

// A point of an element.
struct PlaceOnElement {
    Rgb radiosity{0.0F};  // W/m2
    float exposure = 1;   // of its patch
};

class Lighting {
  public:
    explicit Lighting(const Hierarchy& hierarchy);

    // Takes in nodes that were opened since: until light is gathered, a child has its parent's irradiance.
    void grow(const Control& control);

    // Sorts the links by receiver, keeping their order otherwise, and finds what near links hit. They stay the
    // caller's.
    void set_links(Links& links, const Control& control);

    // Back to what surfaces emit by themselves. Light that coarse links let through would else die out only after all
    // other light has come to rest.
    void clear(const Control& control);

    // One Jacobi iteration: gathers over the links, pushes, pulls. Returns the largest relative step: the change of the
    // total reflected power over the power [0..].
    double iterate(const Control& control);

    // Iterates until a step is at most `converged`, at most `most` times; returns how often. Sampled links may send on
    // a little more than they get. Where steps do not shrink, all light between surfaces is dimmed until they do.
    int settle(int most, double converged, const Control& control);

    // From now on a leaf cluster has this light, whatever its links tell: power that arrives at its faces and that they
    // reflect [W], and how it leaves [W/sr].
    void set_faces_of(NodeId leaf_cluster, Rgb arriving, Rgb reflected, const DirectionalForm& intensity);

    // The mean irradiance of a leaf element, W/m2; its course over the element stays what links made it.
    void set_irradiance(NodeId leaf_element, Rgb mean);

    // Up the hierarchy, after leaves were set.
    void pull(const Control& control);

    // Scales all light that links bring from surface to surface; 1 at first.
    [[nodiscard]] float gain() const { return gain_; }

    // Means over the node's faces, W/m2. Lamps and sky have their emission as radiosity.
    [[nodiscard]] Rgb radiosity(NodeId id) const { return radiosity_[id]; }
    [[nodiscard]] Rgb irradiance(NodeId id) const { return irradiance_[id]; }
    [[nodiscard]] const std::vector<Rgb>& irradiances() const { return irradiance_; }  // per node
    // Standard deviation of the luminance of radiosity over a node's faces, W/m2, as far as the hierarchy tells it.
    [[nodiscard]] float spread(NodeId id) const { return spread_[id]; }
    // Irradiance at an element's corners, linear in between, >= 0.
    [[nodiscard]] const std::array<Rgb, 3>& corner_irradiance(NodeId element) const { return corners_[slot_[element]]; }
    // The light at a point of an element, as finely as it is known.
    [[nodiscard]] PlaceOnElement at(NodeId element, Vec3 point) const;
    // Mean radiosity of the part around a point, so many levels below an element, or there if it is not so divided.
    [[nodiscard]] Rgb mean_around(NodeId element, Vec3 point, int levels) const;
    // The undivided element there.
    [[nodiscard]] NodeId leaf_element_at(NodeId element, Vec3 point) const;
    // All that arrives at a cluster's face with this exposure on one side; unit normal of that side.
    [[nodiscard]] Rgb irradiance_of_face(NodeId cluster, const Exposure& exposure, bool back, Vec3 normal) const;
    [[nodiscard]] const DirectionalForm& intensity(NodeId cluster) const { return intensity_[slot_[cluster]]; }
    // Exact area once light was gathered, m2.
    [[nodiscard]] double area(NodeId id) const { return area_[id]; }
    [[nodiscard]] double reflected_power() const { return reflected_power_; }
    [[nodiscard]] std::size_t bytes() const;

  private:
    // By a cluster.
    struct Received {
        DirectionalForm far, near;  // at an exposure of 1, at a shelter of 1
    };

    void balance_brightness();
    void make_leaf_clusters(const Control& control);
    void find_facing_areas(const Control& control);
    void gather(NodeId receiver);
    [[nodiscard]] static Rgb on_face(const Received& light, const Exposure& face, bool back, Vec3 normal);
    [[nodiscard]] Rgb radiosity_at(const NearHit& hit) const;
    void gather_near(const Link& link, DirectionalForm& form, std::array<Rgb, 3>& corners) const;
    [[nodiscard]] NodeId leaf_at(NodeId sender, const NearHit& hit) const;
    void push(NodeId id);
    void pull(NodeId id);
    [[nodiscard]] double total_reflected_power() const;

    const Hierarchy& hierarchy_;
    std::vector<Rgb> radiosity_, irradiance_;
    std::vector<float> spread_;
    std::vector<double> area_;
    std::vector<std::uint32_t> slot_;          // cluster -> received_, intensity_, facing_; element -> corners_, near_
    std::vector<std::array<Rgb, 3>> corners_;  // irradiance at an element's corners; with patches, at an exposure of 1
    std::vector<Rgb> near_;                    // what arrives from near at an element with patches, at a shelter of 1
    std::vector<Received> received_;
    std::vector<DirectionalForm> intensity_;
    std::vector<FacingArea> facing_;        // of clusters that receive
    std::vector<Received> shining_;         // received_ of the iteration before
    std::vector<std::uint32_t> leaf_slot_;  // leaf cluster -> leaves_, or kNone
    std::vector<LeafCluster> leaves_;
    std::vector<std::uint8_t> known_;  // per node: a leaf cluster whose faces were set
    std::span<const Link> links_;
    std::span<const NearHit> hits_;
    std::vector<std::uint32_t> link_order_, link_begin_;
    double reflected_power_ = 0;
    std::vector<float> balance_;  // per instance: factor on what its elements send over uneven links
    float gain_ = 1;              // of light between surfaces
};

}  // namespace gg
