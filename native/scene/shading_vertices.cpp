#include "scene/shading_vertices.h"

namespace gg {

namespace {

constexpr int kMostCompared = 32;

// Shading vertices of one position as a linked list, latest first.
struct VertexLists {
    std::vector<std::uint32_t> latest;  // per position
    std::vector<std::uint32_t> before;  // per shading vertex
};

std::uint32_t find_or_add(VertexLists& lists, std::vector<Vec3>& normals, std::uint32_t position, Vec3 normal,
                          float tolerance_squared) {
    std::uint32_t candidate = lists.latest[position];
    for (int compared = 0; candidate != kNone && compared < kMostCompared; ++compared) {
        if (length_squared(normals[candidate] - normal) <= tolerance_squared) {
            return candidate;
        }
        candidate = lists.before[candidate];
    }
    const auto added = static_cast<std::uint32_t>(normals.size());
    normals.push_back(normal);
    lists.before.push_back(lists.latest[position]);
    lists.latest[position] = added;
    return added;
}

}  // namespace

ShadingVertices make_shading_vertices(std::span<const TriangleCorners> triangles, std::span<const std::uint32_t> welded,
                                      std::span<const Vec3> corner_normals, float tolerance) {
    ShadingVertices result;
    result.triangles.resize(triangles.size());
    result.normals.reserve(welded.size());
    VertexLists lists;
    lists.latest.assign(welded.size(), kNone);
    lists.before.reserve(welded.size());
    for (std::size_t triangle = 0; triangle < triangles.size(); ++triangle) {
        for (int corner = 0; corner < 3; ++corner) {
            result.triangles[triangle][corner] =
                find_or_add(lists, result.normals, welded[triangles[triangle][corner]],
                            corner_normals[3 * triangle + corner], tolerance * tolerance);
        }
    }
    return result;
}

}  // namespace gg
