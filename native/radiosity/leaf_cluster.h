// Clusters that were not opened, as one thing that receives, reflects and emits.
#pragma once

#include <array>

#include "radiosity/hierarchy.h"
#include "transport/directional_form.h"

namespace gg {

// What a leaf cluster does with light, summed over its faces so that no iteration visits them.
struct LeafCluster {
    ReflectionOperator reflect;       // of what arrives from afar, at an exposure of 1
    ReflectionOperator reflect_near;  // of what arrives from within, at a shelter of 1
    DirectionalForm emission;         // W/sr
    Rgb emitted_power{0.0F};          // W
    double area = 0;                  // m2, every lit side
};

// The lit sides of a cluster's faces as moments of form_basis, m2: as they are, times exposure and times shelter. Such
// moments times a form that falls on all faces alike, or at an exposure or a shelter of 1, are its power.
struct FacingArea {
    std::array<float, kFormSize> area{}, exposed{}, sheltered{};
};

[[nodiscard]] FacingArea facing_area(const Hierarchy& hierarchy, const Node& node);

// By what to scale light that falls on all faces alike, so that the same power arrives when it is shared out by
// exposure or by shelter.
[[nodiscard]] float share_out_far(const FacingArea& facing, const DirectionalForm& light);
[[nodiscard]] float share_out_near(const FacingArea& facing, const DirectionalForm& light);

[[nodiscard]] LeafCluster make_leaf_cluster(const Hierarchy& hierarchy, const Node& node);

}  // namespace gg
