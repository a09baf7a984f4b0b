// The triangles that are seen, divided until they are about as large as is wanted, without cracks.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

#include "radiosity/solution.h"
#include "radiosity/t_vertices.h"

namespace gg {

// Where a surface is seen.
struct SurfaceSpot {
    std::uint32_t instance = 0, triangle = 0;
    bool back = false;
    Vec2 barycentric{0.0F};  // weights of corners 1 and 2
};

// A triangle's part: the quarter of a quarter ...
struct SurfacePart {
    std::uint32_t instance = 0, triangle = 0;
    bool back = false;
    std::uint8_t depth = 0;
    std::uint32_t quarters = 0;  // two bits for each, the first one lowest

    auto operator<=>(const SurfacePart&) const = default;
};

// Vertices around a spot. Weights are >= 0 and change continuously from spot to spot; what they lack of 1 is left to
// others: where triangles are much smaller than wanted.
struct SurfacePlace {
    std::array<std::uint32_t, 3> vertices{};
    std::array<float, 3> weights{};

    [[nodiscard]] float sum() const { return weights[0] + weights[1] + weights[2]; }
};

class SurfaceMesh {
  public:
    // Between two points, in units of the longest side that a triangle there should have.
    using LengthOf = std::function<float(Vec3 a, Vec3 b)>;

    struct Settings {
        LengthOf length_of;
        // As published: only where the solution's own elements are as fine as that, and never in clusters.
        bool elements_alone = false;
    };

    // The solution must outlive this.
    SurfaceMesh(const Solution& solution, Settings settings);

    // The part that a spot lies in, as fine as wanted.
    [[nodiscard]] SurfacePart part_at(const SurfaceSpot& spot) const;
    // Divides what has to be. seen: in ascending order, each once.
    void divide(std::span<const SurfacePart> seen);

    [[nodiscard]] SurfacePlace place(const SurfaceSpot& spot) const;
    [[nodiscard]] std::uint32_t vertex_count() const { return vertex_count_; }

  private:
    struct Vertex {
        std::uint32_t id = 0;
        float strength = 1;  // 0..1: how much it counts
    };
    // One side of an instance.
    struct Side {
        Midpoints midpoints;
        std::unordered_map<std::uint32_t, Vertex> vertices;  // those that count
    };

    [[nodiscard]] const Corners& corners_of(std::uint32_t instance, std::uint32_t triangle) const;
    [[nodiscard]] float strength_of(const SurfacePart& part) const;
    void make_midpoints_of(const SurfacePart& part, Side& side) const;
    // body(vertex) for the vertices of all pieces of a part.
    template <typename Body>
    void for_each_vertex(const SurfacePart& part, const Side& side, const Body& body) const;

    const Solution& solution_;
    Settings settings_;
    std::vector<std::array<Side, 2>> sides_;  // per instance: front, back
    std::uint32_t vertex_count_ = 0;
};

}  // namespace gg
