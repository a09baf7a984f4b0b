// What tests read off a solution: means over faces, and sums of power.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "radiosity/solution_data.h"

namespace gg::test {

// By area over leaves of the hierarchy.
struct FaceMeans {
    Vec3d radiosity{0.0}, irradiance{0.0};  // W/m2
    double area = 0;                        // m2, every lit side
    double least = 0, most = 0;             // radiosity of one leaf, luminance, W/m2
};

[[nodiscard]] double luminance_of(Vec3d color);

// Elements and clusters that are not opened.
[[nodiscard]] std::vector<NodeId> surface_leaves(const Solution& solution);

// Over the leaves that `pick` takes; they may not be none.
[[nodiscard]] FaceMeans means_of(const Solution& solution, const std::function<bool(const Node&)>& pick);

// Everything of an instance but the backs of its elements: the inside of a room's wall, the outside of a solid.
[[nodiscard]] FaceMeans means_of_instance(const Solution& solution, std::uint32_t instance);

// Power that arrives at all surfaces, W, luminance.
[[nodiscard]] double arriving_power(const Solution& solution);

}  // namespace gg::test
