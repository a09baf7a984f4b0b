#include "transport/sky_cell.h"

#include <algorithm>

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

SkyCell finest_cell_at(Vec3 direction) {
    constexpr int kCells = 1 << kFinestSkyLevel;
    const float up = std::abs(direction.z);
    const float stretch = std::sqrt(1 + std::min(up, 1.0F));  // sqrt(2 - squared) of square_to_hemisphere()
    const Vec2 place = disk_to_square(Vec2(direction) / stretch);
    const auto index = [](float x) {
        return static_cast<std::uint16_t>(std::clamp(static_cast<int>(x * kCells), 0, kCells - 1));
    };
    return {kFinestSkyLevel, static_cast<std::uint8_t>(direction.z < 0 ? 1 : 0), index(place.x), index(place.y)};
}

bool contains(SkyCell cell, SkyCell part) {
    const int finer = part.level - cell.level;
    return finer >= 0 && part.face == cell.face && part.i >> finer == cell.i && part.j >> finer == cell.j;
}

float cell_solid_angle(SkyCell cell) {
    return std::ldexp(2 * kPi, -2 * cell.level);
}

Vec3 square_to_sphere(float u, float v) {
    return u < 0.5F ? cell_direction({0, 0, 0, 0}, 2 * u, v) : cell_direction({0, 1, 0, 0}, 2 * u - 1, v);
}

}  // namespace gg
