#include "support/clouds.h"

#include <array>
#include <cmath>

#include "core/random.h"
#include "transport/sky_cell.h"

namespace gg::test {

namespace {

struct Placed {
    Vec3 center;
    Vec3 axes[3];  // orthonormal, even over all rotations
};

Placed place(const Box& box, std::uint64_t seed, std::uint32_t index) {
    const auto number = [&](std::uint64_t dimension) { return unit_float(hash64(hash64(seed, index), dimension)); };
    const Frame frame(square_to_sphere(number(0), number(1)));
    const float angle = 2 * kPi * number(2);
    const Vec3 x = std::cos(angle) * frame.tangent + std::sin(angle) * frame.bitangent;
    return {box.lower + box.extent() * Vec3(number(3), number(4), number(5)),
            {x, cross(frame.normal, x), frame.normal}};
}

// Corner bits x, y, z; outward counter-clockwise.
constexpr std::array<std::uint32_t, 36> kCube = {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                                                 2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};

}  // namespace

MeshDescription triangle_cloud(const Box& box, std::uint32_t count, float edge, std::uint64_t seed) {
    MeshDescription mesh;
    mesh.name = "triangles";
    const float radius = edge / std::sqrt(3.0F);
    for (std::uint32_t i = 0; i < count; ++i) {
        const Placed p = place(box, seed, i);
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            const float angle = 2 * kPi * static_cast<float>(corner) / 3;
            mesh.positions.push_back(p.center + radius * (std::cos(angle) * p.axes[0] + std::sin(angle) * p.axes[1]));
            mesh.triangle_vertices.push_back(3 * i + corner);
        }
    }
    return mesh;
}

MeshDescription cube_cloud(const Box& box, std::uint32_t count, float edge, std::uint64_t seed) {
    MeshDescription mesh;
    mesh.name = "cubes";
    for (std::uint32_t i = 0; i < count; ++i) {
        const Placed p = place(box, seed, i);
        for (std::uint32_t corner = 0; corner < 8; ++corner) {
            Vec3 position = p.center;
            for (std::uint32_t axis = 0; axis < 3; ++axis) {
                position += ((corner >> axis & 1U) != 0 ? 0.5F : -0.5F) * edge * p.axes[axis];
            }
            mesh.positions.push_back(position);
        }
        for (const std::uint32_t vertex : kCube) {
            mesh.triangle_vertices.push_back(8 * i + vertex);
        }
    }
    return mesh;
}

}  // namespace gg::test
