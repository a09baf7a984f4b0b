// The converged lighting of a scene: what the picture and the final gather read.
#pragma once

#include <cstdint>
#include <memory>

#include <array>
#include <span>

#include "core/vec.h"
#include "radiosity/hierarchy.h"
#include "radiosity/link.h"
#include "trace/ray_tracer.h"

namespace gg {

struct Solution;  // radiosity/solution_data.h; immutable, may be read by many threads

// Irradiance [W/m2] at a point of a triangle's front or back, interpolated between the vertices of the elements around
// it: continuous across elements, T-vertices and triangles that share a shading vertex. `barycentric` are the weights
// of corners 1 and 2. 0 where no light was linked.
[[nodiscard]] Rgb interpolated_irradiance(const Solution& solution, std::uint32_t instance, std::uint32_t triangle,
                                          bool back, Vec2 barycentric);

// The nodes that send and receive.
[[nodiscard]] const Hierarchy& hierarchy_of(const Solution& solution);

// The undivided element or leaf cluster around a point of a triangle's front or back; kNone: no light reaches it.
[[nodiscard]] NodeId place_at(const Solution& solution, std::uint32_t instance, std::uint32_t triangle, bool back,
                              Vec3 point);

// Links of the node itself; those of its ancestors bring it light as well.
[[nodiscard]] std::span<const Link> links_to(const Solution& solution, NodeId receiver);

// Mean over the node's faces, W/m2; of lamps and sky: emission.
[[nodiscard]] Rgb radiosity_of(const Solution& solution, NodeId node);
// Of the undivided element around a point of an element.
[[nodiscard]] Rgb radiosity_at(const Solution& solution, NodeId element, Vec3 point);
// Standard deviation of its luminance over the node's faces, W/m2.
[[nodiscard]] float spread_of(const Solution& solution, NodeId node);

// Where a ray met a face.
struct LitPlace {
    NodeId place = kNone;  // undivided element or leaf cluster; kNone: no light reaches it
    Rgb radiosity{0.0F};  // there, W/m2: over an element it changes as between its corners, over a cluster face by face
};
[[nodiscard]] LitPlace lit_place(const Solution& solution, const Hit& hit, bool back);

// At the corners of an undivided element, W/m2: between it and its neighbours, scaled so that the mean is the
// element's.
[[nodiscard]] std::array<Rgb, 3> corner_radiosity(const Solution& solution, NodeId leaf_element);

// Of a side of a triangle in a leaf cluster, W/m2.
[[nodiscard]] Rgb face_radiosity(const Solution& solution, std::uint32_t instance, std::uint32_t triangle, bool back);

}  // namespace gg
