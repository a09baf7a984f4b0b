#include "scene/closed_solids.h"

#include <algorithm>
#include <numeric>

#include "core/control.h"
#include "scene/enclosing.h"

namespace gg {

namespace {

// Below this share of its box's diagonal to the third, a volume is rounding, and its sign says nothing.
constexpr double kLeastVolumeShare = 1e-9;

// A side of a triangle, filed under the lower of its two vertices.
struct HalfEdge {
    std::uint32_t upper_vertex;
    std::uint32_t triangle;
    bool ascending;  // runs from the lower vertex to the upper
};

struct HalfEdges {
    std::vector<std::uint32_t> begin;  // per vertex, one more at the end
    std::vector<HalfEdge> edges;
};

template <typename Visit>
void visit_half_edges(std::span<const TriangleCorners> triangles, std::span<const std::uint32_t> welded,
                      const Visit& visit) {
    for (std::uint32_t triangle = 0; triangle < triangles.size(); ++triangle) {
        for (int corner = 0; corner < 3; ++corner) {
            visit(triangle, welded[triangles[triangle][corner]], welded[triangles[triangle][(corner + 1) % 3]]);
        }
    }
}

// Counting sort: linear, and the order within a vertex is that of the triangles.
HalfEdges file_half_edges(std::span<const TriangleCorners> triangles, std::span<const std::uint32_t> welded) {
    HalfEdges result;
    result.begin.assign(welded.size() + 2, 0);
    visit_half_edges(triangles, welded, [&](std::uint32_t, std::uint32_t from, std::uint32_t to) {
        ++result.begin[std::min(from, to) + 2];
    });
    std::partial_sum(result.begin.begin(), result.begin.end(), result.begin.begin());
    result.edges.resize(3 * triangles.size());
    // begin[v + 1] is the fill position of vertex v, and thereby its end when all is filed.
    visit_half_edges(triangles, welded, [&](std::uint32_t triangle, std::uint32_t from, std::uint32_t to) {
        result.edges[result.begin[std::min(from, to) + 1]++] = {std::max(from, to), triangle, from < to};
    });
    result.begin.pop_back();
    return result;
}

class DisjointSets {
  public:
    explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }
    std::uint32_t find(std::uint32_t item) {
        while (parent_[item] != item) {
            parent_[item] = parent_[parent_[item]];
            item = parent_[item];
        }
        return item;
    }
    // The lower root stays: trees are shallow since neighbours have near indices, and numbering is stable.
    void unite(std::uint32_t a, std::uint32_t b) {
        a = find(a);
        b = find(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::uint32_t> parent_;
};

// Unites the triangles of each edge and marks those with an edge that is not between two opposite neighbours.
std::vector<std::uint8_t> connect_triangles(HalfEdges& half_edges, DisjointSets& sets, std::size_t triangle_count) {
    std::vector<std::uint8_t> on_open_edge(triangle_count, 0);
    for (std::size_t vertex = 0; vertex + 1 < half_edges.begin.size(); ++vertex) {
        const std::span<HalfEdge> edges(half_edges.edges.data() + half_edges.begin[vertex],
                                        half_edges.edges.data() + half_edges.begin[vertex + 1]);
        std::sort(edges.begin(), edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
            return a.upper_vertex != b.upper_vertex ? a.upper_vertex < b.upper_vertex : a.triangle < b.triangle;
        });
        for (std::size_t first = 0, end = 0; first < edges.size(); first = end) {
            for (end = first; end < edges.size() && edges[end].upper_vertex == edges[first].upper_vertex; ++end) {
                sets.unite(edges[first].triangle, edges[end].triangle);
            }
            if (end - first != 2 || edges[first].ascending == edges[first + 1].ascending) {
                on_open_edge[edges[first].triangle] = 1;
            }
        }
    }
    return on_open_edge;
}

struct Component {
    Box box;
    double volume = 0;  // signed, m3
    Vec3 origin{0.0F};  // a point near, against cancellation
    bool open = false;
};

double tetrahedron_volume(Vec3d a, Vec3d b, Vec3d c) {
    return glm::dot(a, glm::cross(b, c)) / 6.0;
}

Sides lit_sides(const Component& component, bool encloses) {
    const double diagonal = component.box.diameter();
    if (component.open || encloses ||
        std::abs(component.volume) <= kLeastVolumeShare * diagonal * diagonal * diagonal) {
        return Sides::kBoth;
    }
    return component.volume > 0 ? Sides::kFront : Sides::kBack;
}

}  // namespace

std::vector<Sides> find_lit_sides(std::span<const Vec3> positions, std::span<const TriangleCorners> triangles,
                                  std::span<const std::uint32_t> welded, const Control& control) {
    HalfEdges half_edges = file_half_edges(triangles, welded);
    control.check_cancel();
    DisjointSets sets(triangles.size());
    const std::vector<std::uint8_t> on_open_edge = connect_triangles(half_edges, sets, triangles.size());
    control.check_cancel();

    // Roots are the lowest triangle of their component: seen first.
    std::vector<std::uint32_t> component_of(triangles.size());
    std::vector<Component> components;
    for (std::uint32_t triangle = 0; triangle < triangles.size(); ++triangle) {
        const Vec3 corners[3] = {positions[triangles[triangle][0]], positions[triangles[triangle][1]],
                                 positions[triangles[triangle][2]]};
        const std::uint32_t root = sets.find(triangle);
        if (root == triangle) {
            component_of[triangle] = static_cast<std::uint32_t>(components.size());
            components.emplace_back().origin = corners[0];
        }
        component_of[triangle] = component_of[root];
        Component& component = components[component_of[triangle]];
        component.open |= on_open_edge[triangle] != 0;
        const Vec3d origin(component.origin);
        component.volume +=
            tetrahedron_volume(Vec3d(corners[0]) - origin, Vec3d(corners[1]) - origin, Vec3d(corners[2]) - origin);
        for (const Vec3 corner : corners) {
            component.box.extend(corner);
        }
    }

    std::vector<Box> boxes(components.size());
    std::transform(components.begin(), components.end(), boxes.begin(), [](const Component& c) { return c.box; });
    const std::vector<std::uint8_t> enclosing = find_enclosing(boxes, boxes.size(), control);
    std::vector<Sides> sides(triangles.size());
    for (std::size_t triangle = 0; triangle < triangles.size(); ++triangle) {
        const std::uint32_t component = component_of[triangle];
        sides[triangle] = lit_sides(components[component], enclosing[component] != 0);
    }
    return sides;
}

}  // namespace gg
