// Clusters that were not opened, as one thing that receives, reflects and emits.
#pragma once

#include "radiosity/hierarchy.h"
#include "transport/directional_form.h"

namespace gg {

// What a leaf cluster does with light, summed over its faces so that no iteration visits them.
struct LeafCluster {
    ReflectionOperator reflect;
    DirectionalForm emission;  // W/sr
    Rgb emitted_power{0.0F};   // W
    double area = 0;           // m2, every lit side
};

[[nodiscard]] LeafCluster make_leaf_cluster(const Hierarchy& hierarchy, const Node& node);

}  // namespace gg
