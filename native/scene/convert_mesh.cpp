#include "scene/convert_mesh.h"

#include <algorithm>
#include <cmath>

#include "core/control.h"
#include "core/parallel.h"
#include "scene/closed_solids.h"
#include "scene/shading_vertices.h"
#include "scene/weld.h"

namespace gg {

namespace {

constexpr std::size_t kBlock = 16384;  // triangles
constexpr float kLargestCoordinate = 1e9F;
constexpr double kLeastHeightShare = 3e-7;
constexpr double kLeastDoubledArea = 1e-18;  // m2: its square still is a normal float
constexpr float kSameNormal = 1e-4F;
constexpr float kSameFlatNormal = 1e-3F;  // geometric normals of coplanar triangles differ by rounding

// The description's arrays, as far as their lengths fit each other.
struct Source {
    const MeshDescription& mesh;
    std::size_t triangle_count;
    bool corners, slots, normals, uvs;

    explicit Source(const MeshDescription& description)
        : mesh(description),
          triangle_count(description.triangle_vertices.size() / 3),
          corners(description.triangle_corners.size() == 3 * triangle_count && triangle_count > 0),
          slots(description.triangle_slots.size() == triangle_count),
          normals(corners && !description.corner_normals.empty()),
          uvs(corners && !description.corner_uvs.empty()) {}

    [[nodiscard]] bool ignores_something() const {
        return (!slots && !mesh.triangle_slots.empty()) || (!normals && !mesh.corner_normals.empty()) ||
               (!uvs && !mesh.corner_uvs.empty());
    }
    [[nodiscard]] std::uint32_t corner(std::size_t triangle, int index) const {
        return mesh.triangle_corners[3 * triangle + index];
    }
    [[nodiscard]] TriangleCorners vertices(std::size_t triangle) const {
        const std::uint32_t* first = mesh.triangle_vertices.data() + 3 * triangle;
        return {first[0], first[1], first[2]};
    }
};

bool is_usable(Vec3 p) {
    return is_finite(p) && max_component(glm::abs(p)) <= kLargestCoordinate;
}

bool has_area(Vec3d a, Vec3d b, Vec3d c) {
    const Vec3d sides[3] = {b - a, c - b, a - c};
    const double doubled_area = glm::length(glm::cross(sides[0], sides[1]));
    const double longest =
        std::max({glm::dot(sides[0], sides[0]), glm::dot(sides[1], sides[1]), glm::dot(sides[2], sides[2])});
    return doubled_area > std::max(kLeastDoubledArea, kLeastHeightShare * longest);
}

TriangleFault find_fault(const Source& source, std::size_t triangle) {
    const MeshDescription& mesh = source.mesh;
    const TriangleCorners v = source.vertices(triangle);
    if (*std::max_element(v.begin(), v.end()) >= mesh.positions.size()) {
        return TriangleFault::kBadIndex;
    }
    for (int index = 0; index < 3; ++index) {
        if ((source.normals && source.corner(triangle, index) >= mesh.corner_normals.size()) ||
            (source.uvs && source.corner(triangle, index) >= mesh.corner_uvs.size())) {
            return TriangleFault::kBadIndex;
        }
    }
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) {
        return TriangleFault::kRepeatedVertex;
    }
    const Vec3 a = mesh.positions[v[0]], b = mesh.positions[v[1]], c = mesh.positions[v[2]];
    if (!is_usable(a) || !is_usable(b) || !is_usable(c)) {
        return TriangleFault::kNotFinite;
    }
    return has_area(a, b, c) ? TriangleFault::kUsable : TriangleFault::kNoArea;
}

Vec3 geometric_normal(const Mesh& mesh, const TriangleCorners& v) {
    const Vec3d a(mesh.positions[v[0]]), b(mesh.positions[v[1]]), c(mesh.positions[v[2]]);
    return Vec3(glm::normalize(glm::cross(b - a, c - a)));
}

// The corner's own normal where it has one that points anywhere.
Vec3 shading_normal(const Source& source, std::size_t triangle, int index, Vec3 geometric) {
    if (!source.normals) {
        return geometric;
    }
    const Vec3 normal = source.mesh.corner_normals[source.corner(triangle, index)];
    const float squared = length_squared(normal);
    return squared > 1e-12F && squared < 1e12F ? normal / std::sqrt(squared) : geometric;
}

Vec2 finite_or_zero(Vec2 uv) {
    return {std::isfinite(uv.x) ? uv.x : 0.0F, std::isfinite(uv.y) ? uv.y : 0.0F};
}

// Solids are judged with their flat triangles, which close them, but without those that collapse into an edge.
std::vector<Sides> find_sides(const Source& source, const std::vector<TriangleFault>& faults, const Mesh& mesh,
                              const std::vector<std::uint32_t>& welded, const Control& control) {
    std::vector<TriangleCorners> connecting;
    std::vector<std::uint32_t> usable;  // indices into `connecting`
    connecting.reserve(faults.size());
    usable.reserve(mesh.triangles.size());
    for (std::size_t triangle = 0; triangle < faults.size(); ++triangle) {
        const TriangleFault fault = faults[triangle];
        if (fault != TriangleFault::kUsable && fault != TriangleFault::kNoArea) {
            continue;
        }
        const TriangleCorners v = source.vertices(triangle);
        if (welded[v[0]] == welded[v[1]] || welded[v[1]] == welded[v[2]] || welded[v[2]] == welded[v[0]]) {
            continue;
        }
        if (fault == TriangleFault::kUsable) {
            usable.push_back(static_cast<std::uint32_t>(connecting.size()));
        }
        connecting.push_back(v);
    }
    const std::vector<Sides> sides = find_lit_sides(mesh.positions, connecting, welded, control);
    std::vector<Sides> result(usable.size());
    std::transform(usable.begin(), usable.end(), result.begin(), [&](std::uint32_t index) { return sides[index]; });
    return result;
}

void copy_triangles(const Source& source, const std::vector<std::uint32_t>& kept, const Control& control, Mesh& mesh) {
    mesh.positions = source.mesh.positions;
    for (Vec3& position : mesh.positions) {
        position = is_usable(position) ? position : Vec3(0);  // of no triangle that is kept
    }
    mesh.triangles.resize(kept.size());
    mesh.slots.resize(source.slots ? kept.size() : 0);
    mesh.uvs.resize(source.uvs ? 3 * kept.size() : 0);
    parallel_for(kept.size(), kBlock, control, [&](std::size_t triangle) {
        mesh.triangles[triangle] = source.vertices(kept[triangle]);
        if (source.slots) {
            mesh.slots[triangle] = source.mesh.triangle_slots[kept[triangle]];
        }
        for (int index = 0; index < 3 && source.uvs; ++index) {
            mesh.uvs[3 * triangle + index] =
                finite_or_zero(source.mesh.corner_uvs[source.corner(kept[triangle], index)]);
        }
    });
    for (const TriangleCorners& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) {
            mesh.bounds.extend(mesh.positions[vertex]);
        }
    }
}

void add_shading(const Source& source, const std::vector<std::uint32_t>& kept, const std::vector<std::uint32_t>& welded,
                 const Control& control, Mesh& mesh) {
    std::vector<Vec3> corner_normals(3 * kept.size());
    parallel_for(kept.size(), kBlock, control, [&](std::size_t triangle) {
        const Vec3 geometric = geometric_normal(mesh, mesh.triangles[triangle]);
        for (int index = 0; index < 3; ++index) {
            corner_normals[3 * triangle + index] = shading_normal(source, kept[triangle], index, geometric);
        }
    });
    ShadingVertices shading =
        make_shading_vertices(mesh.triangles, welded, corner_normals, source.normals ? kSameNormal : kSameFlatNormal);
    mesh.shading_vertices = std::move(shading.triangles);
    mesh.normals = std::move(shading.normals);
}

}  // namespace

const char* fault_text(TriangleFault fault) {
    switch (fault) {
        case TriangleFault::kBadIndex:
            return "Triangle names vertices or corners that do not exist: left out";
        case TriangleFault::kRepeatedVertex:
            return "Triangle uses a vertex twice: left out";
        case TriangleFault::kNotFinite:
            return "Triangle has a coordinate that is not a usable number: left out";
        case TriangleFault::kNoArea:
            return "Triangle has no area: left out";
        default:
            return "";
    }
}

ConvertedMesh convert_mesh(const MeshDescription& description, const Control& control) {
    const Source source(description);
    ConvertedMesh result;
    result.mesh.name = description.name;
    result.ignored_attributes = source.ignores_something();
    std::vector<TriangleFault> faults(source.triangle_count);
    parallel_for(faults.size(), kBlock, control,
                 [&](std::size_t triangle) { faults[triangle] = find_fault(source, triangle); });
    std::vector<std::uint32_t> kept;
    for (std::uint32_t triangle = 0; triangle < faults.size(); ++triangle) {
        ++result.count[static_cast<std::size_t>(faults[triangle])];
        if (faults[triangle] == TriangleFault::kUsable) {
            kept.push_back(triangle);
        }
    }
    if (kept.empty()) {
        return result;
    }
    copy_triangles(source, kept, control, result.mesh);
    const std::vector<std::uint32_t> welded = weld_positions(result.mesh.positions);
    // The two long steps that follow one mesh's order; they share nothing that either writes.
    parallel_for(2, 1, control, [&](std::size_t step) {
        if (step == 0) {
            add_shading(source, kept, welded, control, result.mesh);
        } else {
            result.mesh.sides = find_sides(source, faults, result.mesh, welded, control);
        }
    });
    return result;
}

}  // namespace gg
