// Light that senders bring if nothing is in the way.
#pragma once

#include <span>

#include "core/wide.h"
#include "gather/sender_points.h"
#include "radiosity/solution.h"
#include "transport/emitter_sampling.h"

namespace gg {

// Irradiance [W/m2] of an element or a lamp at x on unit normal n, clipped against its horizon.
[[nodiscard]] Rgb unoccluded_irradiance(const Solution& solution, NodeId sender, Vec3 x, Vec3 n);

// The same of any sender but the sky; of a cluster by its points.
[[nodiscard]] Rgb unoccluded_irradiance(const Solution& solution, const ClusterPoints& cluster_points, NodeId sender,
                                        Vec3 x, Vec3 n);

// 0..1: how far an element counts as linear, not as even, at a distance [m] from its middle. T: float or Wide.
template <typename T>
[[nodiscard]] T closeness_of(const Node& element, const T& distance) {
    constexpr float kEven = 5, kLinear = 2.5F;  // in radii: even from the first on, linear up to the second
    return clamp(T((kEven - distance / element.radius) / (kEven - kLinear)), T(0), T(1));
}

// In radii: from there on the vector of an element is that of a point.
inline constexpr float kPointDistance = 6;

// The same as a vector, for any normal that has all of the sender above its horizon.
[[nodiscard]] IrradianceVector irradiance_vector(const Solution& solution, NodeId sender, Vec3 x);

// The same of any sender but the sky; of a cluster by its points.
[[nodiscard]] IrradianceVector irradiance_vector(const Solution& solution, const ClusterPoints& cluster_points,
                                                 NodeId sender, Vec3 x);

// Irradiance [W/m2] from a point of a cluster at distance vector `to` on unit normal n, if the point stands for `share`
// times what its power says. Bounded close by: it stands for a disk of `area` [m2].
[[nodiscard]] Rgb irradiance_from(const FacePoint& point, float share, Vec3 to, Vec3 n, float area);

// That area [m2] where all of its points count.
[[nodiscard]] inline float cluster_disk(const Node& cluster) {
    return 0.5F * cluster.area / static_cast<float>(kClusterPoints);
}

}  // namespace gg
