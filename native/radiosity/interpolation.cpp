#include "radiosity/interpolation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"
#include "gridgather.h"
#include "radiosity/instance_parts.h"
#include "radiosity/quarter.h"
#include "radiosity/solution.h"
#include "radiosity/t_vertices.h"

namespace gg {

namespace {

constexpr float kLeastWeight = 1e-3F;

// Of the whole element that a piece is part of.
float area_share(const Piece& piece) {
    const Vec2 e1 = piece.places[1] - piece.places[0], e2 = piece.places[2] - piece.places[0];
    return std::abs(e1.x * e2.y - e1.y * e2.x);
}

class VertexBuilder {
  public:
    VertexBuilder(Solution& solution, std::uint32_t instance, InstanceVertices& out)
        : solution_(solution),
          mesh_(solution.hierarchy.scene().meshes[solution.hierarchy.scene().instances[instance].mesh]),
          instance_(instance),
          out_(out) {}

    void add_elements(std::span<const NodeId> roots) {
        for (const NodeId root : roots) {
            divide_edges(root, mesh_.shading_vertices[solution_.hierarchy[root].source]);
        }
    }

    void average(std::span<const NodeId> roots, std::span<const NodeId> leaf_clusters) {
        const std::size_t count = mesh_.normals.size() + out_.midpoints.size();
        for (auto& side : sums_) {
            side.assign(count, Rgb(0.0F));
        }
        for (auto& side : weights_) {
            side.assign(count, 0.0F);
        }
        for (const NodeId root : roots) {
            const auto& node = solution_.hierarchy[root];
            add_leaves(root, whole_piece(mesh_.shading_vertices[node.source]));
        }
        for (const NodeId cluster : leaf_clusters) {
            add_cluster(cluster);
        }
        store(0, out_.front);
        store(1, out_.back);
    }

  private:
    void divide_edges(NodeId id, const Corners& corners) {
        const Node& node = solution_.hierarchy[id];
        if (node.child_count == 0) {
            return;
        }
        const Corners opposite = make_midpoints(out_.midpoints, mesh_.normals.size(), corners);
        for (int quarter = 0; quarter < 4; ++quarter) {
            divide_edges(node.first_child + quarter, quarter_corners(corners, opposite, quarter));
        }
    }

    void add_leaves(NodeId id, const Piece& piece) {
        const Node& node = solution_.hierarchy[id];
        std::array<Piece, 4> parts;
        const int count = split_at_t_vertices(out_.midpoints, piece, parts);
        if (node.child_count == 0) {
            solution_.element_vertices[id] = {piece.vertices, count > 1};
            add_piece(whole_piece(piece.vertices), node, solution_.lighting.corner_irradiance(id));
            return;
        }
        for (int quarter = 0; quarter < 4; ++quarter) {
            add_leaves(node.first_child + quarter, parts[quarter]);
        }
    }

    void add_piece(const Piece& piece, const Node& node, const std::array<Rgb, 3>& corners) {
        std::array<Piece, 4> parts;
        const int count = split_at_t_vertices(out_.midpoints, piece, parts);
        if (count == 1) {
            // By area: the sum over all is then kept, and a speck of light does not spread over a large neighbour. What
            // is covered is not seen: it must not darken the edge of what is.
            const float weight = node.area * area_share(piece) * std::max(node.weight, kLeastWeight);
            for (int k = 0; k < 3; ++k) {
                const Vec2 w = piece.places[k];
                const Rgb value = (1 - w.x - w.y) * corners[0] + w.x * corners[1] + w.y * corners[2];
                sums_[node.back][piece.vertices[k]] += weight * value;
                weights_[node.back][piece.vertices[k]] += weight;
            }
            return;
        }
        for (int i = 0; i < count; ++i) {
            add_piece(parts[i], node, corners);
        }
    }

    // Faces that stayed in a cluster: the light of their group.
    void add_cluster(NodeId cluster) {
        const Hierarchy& hierarchy = solution_.hierarchy;
        const Scene& scene = hierarchy.scene();
        for_each_triangle_in(hierarchy, cluster, instance_, [&](std::uint32_t triangle) {
            const Sides sides = scene.sides_of(instance_, triangle);
            for (const bool back : {false, true}) {
                if (has_side(sides, back)) {
                    const Rgb irradiance = solution_.face_light.irradiance(instance_, triangle, back);
                    const float area = length(world_area_vector(scene, instance_, triangle));
                    for (const std::uint32_t vertex : mesh_.shading_vertices[triangle]) {
                        sums_[back][vertex] += area * irradiance;
                        weights_[back][vertex] += area;
                    }
                }
            }
        });
    }

    void store(int side, std::vector<Rgb>& values) {
        if (std::none_of(weights_[side].begin(), weights_[side].end(), [](float w) { return w > 0; })) {
            return;
        }
        values.resize(sums_[side].size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            // Weights of places on an edge may be below zero by rounding.
            values[i] = weights_[side][i] > 0 ? glm::max(sums_[side][i] / weights_[side][i], Rgb(0.0F)) : Rgb(0.0F);
        }
    }

    Solution& solution_;
    const Mesh& mesh_;
    std::uint32_t instance_;
    InstanceVertices& out_;
    std::array<std::vector<Rgb>, 2> sums_;
    std::array<std::vector<float>, 2> weights_;
};

Rgb blend(const std::vector<Rgb>& values, const PlaceInPiece& at) {
    return (1 - at.weights.x - at.weights.y) * values[at.vertices[0]] + at.weights.x * values[at.vertices[1]] +
           at.weights.y * values[at.vertices[2]];
}

// The undivided element below `id` around a point of its triangle, and the point's weights of its corners 1 and 2.
std::pair<NodeId, Vec2> leaf_place(const Hierarchy& hierarchy, NodeId id, Vec2 place) {
    while (hierarchy[id].child_count > 0) {
        const int quarter = quarter_at(place);
        place = place_in_quarter(place, quarter);
        id = hierarchy[id].first_child + quarter;
    }
    return {id, place};
}

}  // namespace

void interpolate_to_vertices(Solution& solution, const Control& control) {
    const auto parts = parts_of_instances(solution.hierarchy);
    solution.vertices.resize(parts.size());
    solution.element_vertices.resize(solution.hierarchy.nodes().size());
    parallel_for(parts.size(), 1, control, [&](std::size_t i) {
        const auto instance = static_cast<std::uint32_t>(i);
        if (solution.hierarchy.scene().instances[instance].flags & GG_HIDDEN_FROM_LIGHT) {
            return;
        }
        VertexBuilder builder(solution, instance, solution.vertices[i]);
        builder.add_elements(parts[i].element_roots);
        builder.average(parts[i].element_roots, parts[i].leaf_clusters);
    });
}

Rgb interpolated_irradiance(const Solution& solution, std::uint32_t instance, std::uint32_t triangle, bool back,
                            Vec2 barycentric) {
    const InstanceVertices& vertices = solution.vertices[instance];
    const std::vector<Rgb>& values = back ? vertices.back : vertices.front;
    if (values.empty()) {
        return Rgb(0.0F);
    }
    NodeId id = solution.elements.of(instance, triangle, back);
    if (id == kNone) {
        const Scene& scene = solution.hierarchy.scene();
        const Corners& corners = scene.meshes[scene.instances[instance].mesh].shading_vertices[triangle];
        return vertices.midpoints.empty()
                   ? blend(values, {corners, barycentric})
                   : blend(values, find_piece(vertices.midpoints, whole_piece(corners), barycentric));
    }
    const auto [leaf_element, place] = leaf_place(solution.hierarchy, id, barycentric);
    const ElementVertices& leaf = solution.element_vertices[leaf_element];
    return leaf.has_t_vertices ? blend(values, find_piece(vertices.midpoints, whole_piece(leaf.vertices), place))
                               : blend(values, {leaf.vertices, place});
}

LitPlace lit_place(const Solution& solution, const Hit& hit, bool back) {
    const NodeId element = solution.elements.of(hit.instance, hit.triangle, back);
    if (element == kNone) {
        if (!has_side(solution.hierarchy.scene().sides_of(hit.instance, hit.triangle), back)) {
            return {};
        }
        const NodeId cluster = solution.clusters.of(hit.instance, hit.triangle);
        return {cluster, cluster != kNone ? face_radiosity(solution, hit.instance, hit.triangle, back) : Rgb(0.0F)};
    }
    const auto [leaf, place] = leaf_place(solution.hierarchy, element, {hit.u, hit.v});
    const auto corners = corner_radiosity(solution, leaf);
    return {leaf, (1 - place.x - place.y) * corners[0] + place.x * corners[1] + place.y * corners[2]};
}

}  // namespace gg
