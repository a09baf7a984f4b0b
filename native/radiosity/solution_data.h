// What a solution is made of.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "radiosity/gathered_light.h"
#include "radiosity/hierarchy.h"
#include "radiosity/lighting.h"
#include "radiosity/link.h"
#include "radiosity/reference_white.h"
#include "radiosity/t_vertices.h"

namespace gg {

// Irradiance at the vertices of an instance's elements. Vertices are the mesh's shading vertices, then the midpoints of
// element edges; front and back have values of their own.
struct InstanceVertices {
    Midpoints midpoints;
    std::vector<Rgb> front, back;  // W/m2 per vertex; back is empty when light reaches no back
};

// The corners of a leaf element, so that a look-up needs no search.
struct ElementVertices {
    Corners vertices{};
    bool has_t_vertices = false;  // a neighbour divides one of its edges
};

struct Solution {
    Solution(const Scene& scene, const SurfaceColors& colors, SceneFaces faces)
        : hierarchy(scene, colors, std::move(faces)), lighting(hierarchy) {}
    Solution(const Solution&) = delete;
    Solution& operator=(const Solution&) = delete;

    Hierarchy hierarchy;
    Lighting lighting;
    Links links;
    ReferenceWhite white;
    ElementTable elements;
    ClusterTable clusters;
    std::vector<std::uint32_t> link_begin;  // per node, into links.all, which is in the order of receivers; and the end
    GatheredLight face_light;               // of faces in clusters
    std::vector<InstanceVertices> vertices;         // per instance
    std::vector<ElementVertices> element_vertices;  // per node; set for leaf elements
};

}  // namespace gg
