#include "transport/sky_cell.h"

#include "core/random.h"

namespace gg {
namespace {

// Uniform direction of the hemisphere z > 0 from the unit square by Lambert's equal-area map, r^2 = 1 - z.
Vec3 square_to_hemisphere(float u, float v) {
    const Vec2 disk = square_to_disk(u, v);
    const float squared = std::min(disk.x * disk.x + disk.y * disk.y, 1.0F);
    const float stretch = std::sqrt(2 - squared);
    return {disk.x * stretch, disk.y * stretch, 1 - squared};
}

}  // namespace

std::array<SkyCell, 4> children(SkyCell cell) {
    std::array<SkyCell, 4> result;
    for (int child = 0; child < 4; ++child) {
        result[child] = {static_cast<std::uint8_t>(cell.level + 1), cell.face,
                         static_cast<std::uint16_t>(2 * cell.i + (child & 1)),
                         static_cast<std::uint16_t>(2 * cell.j + (child >> 1))};
    }
    return result;
}

Vec3 cell_direction(SkyCell cell, float u, float v) {
    const float width = std::ldexp(1.0F, -cell.level);
    Vec3 direction =
        square_to_hemisphere((static_cast<float>(cell.i) + u) * width, (static_cast<float>(cell.j) + v) * width);
    if (cell.face == 1) {
        direction.z = -direction.z;
    }
    return direction;
}

float cell_solid_angle(SkyCell cell) {
    return std::ldexp(2 * kPi, -2 * cell.level);
}

Vec3 square_to_sphere(float u, float v) {
    return u < 0.5F ? cell_direction({0, 0, 0, 0}, 2 * u, v) : cell_direction({0, 1, 0, 0}, 2 * u - 1, v);
}

}  // namespace gg
