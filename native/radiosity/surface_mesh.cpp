#include "radiosity/surface_mesh.h"

#include <algorithm>
#include <utility>

#include "radiosity/quarter.h"
#include "radiosity/solution_data.h"

namespace gg {

namespace {

// Height of a whole triangle over the longest side that is wanted of its parts: smaller and thinner ones than the first
// do not count, from the second on they do in full.
constexpr float kTooSmall = 1, kLargeEnough = 2;
constexpr std::uint8_t kDeepest = 15;  // as many quarters as SurfacePart has bits for

float longest_side(const SurfaceMesh::LengthOf& length_of, const std::array<Vec3, 3>& c) {
    return std::max({length_of(c[0], c[1]), length_of(c[1], c[2]), length_of(c[2], c[0])});
}

// Over the longest side, as a share of that.
float height(const std::array<Vec3, 3>& c) {
    const float longest = std::max({length(c[1] - c[0]), length(c[2] - c[1]), length(c[0] - c[2])});
    return length(cross(c[1] - c[0], c[2] - c[0])) / std::max(longest * longest, 1e-30F);
}

int quarter_of_part(const SurfacePart& part, int level) {
    return static_cast<int>(part.quarters >> (2 * level) & 3U);
}

}  // namespace

SurfaceMesh::SurfaceMesh(const Solution& solution, Settings settings)
    : solution_(solution), settings_(std::move(settings)), sides_(solution.hierarchy.scene().instances.size()) {}

const Corners& SurfaceMesh::corners_of(std::uint32_t instance, std::uint32_t triangle) const {
    const Scene& scene = solution_.hierarchy.scene();
    return scene.meshes[scene.instances[instance].mesh].shading_vertices[triangle];
}

SurfacePart SurfaceMesh::part_at(const SurfaceSpot& spot) const {
    SurfacePart part{spot.instance, spot.triangle, spot.back, 0, 0};
    auto corners = world_triangle(solution_.hierarchy.scene(), spot.instance, spot.triangle);
    Vec2 place = spot.barycentric;
    while (part.depth < kDeepest && longest_side(settings_.length_of, corners) > 1) {
        const int quarter = quarter_at(place);
        place = place_in_quarter(place, quarter);
        corners = quarter_of(corners, quarter);
        part.quarters |= static_cast<std::uint32_t>(quarter) << (2 * part.depth++);
    }
    return part;
}

float SurfaceMesh::strength_of(const SurfacePart& part) const {
    auto corners = world_triangle(solution_.hierarchy.scene(), part.instance, part.triangle);
    const float size = longest_side(settings_.length_of, corners) * height(corners);
    NodeId element = solution_.elements.of(part.instance, part.triangle, part.back);
    for (int level = 0; level < part.depth; ++level) {
        const int quarter = quarter_of_part(part, level);
        corners = quarter_of(corners, quarter);
        if (element != kNone) {
            const Node& node = solution_.hierarchy[element];
            element = node.child_count > 0 ? node.first_child + quarter : kNone;
        }
    }
    if (settings_.elements_alone && element == kNone) {
        return 0;
    }
    return glm::smoothstep(kTooSmall, kLargeEnough, size);
}

template <typename Body>
void SurfaceMesh::for_each_vertex(const SurfacePart& part, const Side& side, const Body& body) const {
    Corners corners = corners_of(part.instance, part.triangle);
    for (int level = 0; level < part.depth; ++level) {
        corners = quarter_corners(corners, opposite_midpoints(side.midpoints, corners), quarter_of_part(part, level));
    }
    const auto visit = [&](const auto& self, const Piece& piece) -> void {
        std::for_each(piece.vertices.begin(), piece.vertices.end(), body);
        std::array<Piece, 4> parts;
        const int count = split_at_t_vertices(side.midpoints, piece, parts);
        for (int i = 0; count > 1 && i < count; ++i) {
            self(self, parts[i]);
        }
    };
    visit(visit, whole_piece(corners));
}

void SurfaceMesh::divide(std::span<const SurfacePart> seen) {
    std::vector<float> strengths;
    for (const SurfacePart& part : seen) {
        make_midpoints_of(part, sides_[part.instance][part.back]);
        strengths.push_back(strength_of(part));
    }
    for (std::size_t i = 0; i < seen.size(); ++i) {
        Side& side = sides_[seen[i].instance][seen[i].back];
        if (strengths[i] > 0) {
            for_each_vertex(seen[i], side, [&](std::uint32_t vertex) {
                vertex_count_ += side.vertices.try_emplace(vertex, Vertex{vertex_count_, 1}).second ? 1 : 0;
            });
        }
    }
    // No vertex counts more than any part around it lets it.
    for (std::size_t i = 0; i < seen.size(); ++i) {
        Side& side = sides_[seen[i].instance][seen[i].back];
        if (strengths[i] < 1 && !side.vertices.empty()) {
            for_each_vertex(seen[i], side, [&](std::uint32_t vertex) {
                const auto found = side.vertices.find(vertex);
                if (found != side.vertices.end()) {
                    found->second.strength = std::min(found->second.strength, strengths[i]);
                }
            });
        }
    }
}

// Of all edges of all that contains the part.
void SurfaceMesh::make_midpoints_of(const SurfacePart& part, Side& side) const {
    const Scene& scene = solution_.hierarchy.scene();
    const std::size_t own = scene.meshes[scene.instances[part.instance].mesh].normals.size();
    Corners corners = corners_of(part.instance, part.triangle);
    for (int level = 0; level < part.depth; ++level) {
        const Corners opposite = make_midpoints(side.midpoints, own, corners);
        corners = quarter_corners(corners, opposite, quarter_of_part(part, level));
    }
}

SurfacePlace SurfaceMesh::place(const SurfaceSpot& spot) const {
    const Side& side = sides_[spot.instance][spot.back];
    if (side.vertices.empty()) {
        return {};
    }
    const auto [vertices, weights] =
        find_piece(side.midpoints, whole_piece(corners_of(spot.instance, spot.triangle)), spot.barycentric);
    const std::array<float, 3> inside{1 - weights.x - weights.y, weights.x, weights.y};
    SurfacePlace result;
    for (int k = 0; k < 3; ++k) {
        const auto found = side.vertices.find(vertices[k]);
        if (found != side.vertices.end()) {
            result.vertices[k] = found->second.id;
            result.weights[k] = std::clamp(inside[k], 0.0F, 1.0F) * found->second.strength;
        }
    }
    return result;
}

}  // namespace gg
