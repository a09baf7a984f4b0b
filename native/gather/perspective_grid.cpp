#include "gather/perspective_grid.h"

#include <algorithm>
#include <cmath>

namespace gg {

namespace {

constexpr float kForeshortened = 0.4F;  // share of a length along the view direction that counts
constexpr std::uint32_t kMargin = 1;    // cells beyond the picture's border, since pixel filters reach over it

}  // namespace

PerspectiveGrid::PerspectiveGrid(const PixelCamera& camera, float width, float height, const GridSettings& settings)
    : camera_(camera), settings_(settings) {
    const auto cells = [](float size) { return static_cast<std::uint32_t>(std::ceil(std::max(size, 1.0F))); };
    count_[0] = cells(width / settings.cell) + 2 * kMargin + 1;
    count_[1] = cells(height / settings.cell) + 2 * kMargin + 1;
    count_[2] = 2;
    // As deep as wide, in the middle of what is seen.
    const float middle = std::sqrt(settings.nearest * settings.farthest);
    const float side = settings.cell * camera.pixel_size(middle);
    const float depth = settings.law == DepthLaw::kLogarithmic ? middle * std::log(settings.farthest / settings.nearest)
                                                               : settings.farthest - settings.nearest;
    constexpr float kMostLayers = 256;
    count_[2] = cells(std::min(depth / std::max(side, 1e-9F), kMostLayers)) + 1;
}

// 0 at the nearest depth, 1 at the farthest.
float PerspectiveGrid::layer(float depth) const {
    const float near = settings_.nearest, far = settings_.farthest;
    const float z = std::clamp(depth, near, far);
    if (!(far > near)) {
        return 0;
    }
    switch (settings_.law) {
        case DepthLaw::kLogarithmic:
            return std::log(z / near) / std::log(far / near);
        case DepthLaw::kReciprocal:
            return (1 / near - 1 / z) / (1 / near - 1 / far);
        case DepthLaw::kLinear:
            return (z - near) / (far - near);
    }
    return 0;
}

float PerspectiveGrid::depth_of(float layer) const {
    const float near = settings_.nearest, far = settings_.farthest;
    switch (settings_.law) {
        case DepthLaw::kLogarithmic:
            return near * std::pow(far / near, layer);
        case DepthLaw::kReciprocal:
            return 1 / glm::mix(1 / near, 1 / far, layer);
        case DepthLaw::kLinear:
            return glm::mix(near, far, layer);
    }
    return near;
}

Vec3 PerspectiveGrid::near_vertex(std::uint32_t vertex, Vec3 cells) const {
    const std::array<std::uint32_t, 3> index{vertex % count_[0], vertex / count_[0] % count_[1],
                                             vertex / count_[0] / count_[1]};
    Vec3 grid(0.0F);
    for (int axis = 0; axis < 3; ++axis) {
        const auto last = static_cast<float>(count_[axis] - 1);
        grid[axis] = std::clamp(static_cast<float>(index[axis]) + cells[axis], 0.0F, last);
    }
    const Ray ray = camera_.ray((grid.x - kMargin) * settings_.cell, (grid.y - kMargin) * settings_.cell);
    return ray.origin + depth_of(grid.z / static_cast<float>(count_[2] - 1)) * ray.direction;
}

float PerspectiveGrid::cells_between(Vec3 a, Vec3 b) const {
    const Vec3 middle = 0.5F * (a + b);
    const float depth = std::clamp(camera_.project(middle).z, settings_.nearest, settings_.farthest);
    const float along = dot(b - a, camera_.direction_to(middle));
    const float across = std::max(length_squared(b - a) - along * along, 0.0F);
    return std::sqrt(across + kForeshortened * kForeshortened * along * along) /
           (settings_.cell * camera_.pixel_size(depth));
}

PerspectiveGrid::InCell PerspectiveGrid::locate(Vec3 point) const {
    const Vec3 seen = camera_.project(point);
    const Vec3 grid(seen.x / settings_.cell + kMargin, seen.y / settings_.cell + kMargin,
                    layer(seen.z) * static_cast<float>(count_[2] - 1));
    InCell result;
    for (int axis = 0; axis < 3; ++axis) {
        const auto last = static_cast<float>(count_[axis] - 1);
        const float at = std::clamp(grid[axis], 0.0F, last);
        result.cell[axis] = std::min(static_cast<std::uint32_t>(at), count_[axis] - 2);
        result.inside[axis] = at - static_cast<float>(result.cell[axis]);
    }
    return result;
}

std::uint32_t PerspectiveGrid::cell_at(Vec3 point) const {
    const auto& cell = locate(point).cell;
    return (cell[2] * count_[1] + cell[1]) * count_[0] + cell[0];
}

GridPlace PerspectiveGrid::place(Vec3 point) const {
    const auto [cell, inside] = locate(point);
    const CubePlace cube = place_in_cube(inside, ((cell[0] + cell[1] + cell[2]) & 1U) != 0);
    GridPlace result;
    for (int k = 0; k < 4; ++k) {
        const int corner = cube.corners[k];
        const std::uint32_t x = cell[0] + (corner & 1), y = cell[1] + (corner >> 1 & 1), z = cell[2] + (corner >> 2);
        result.vertices[k] = (z * count_[1] + y) * count_[0] + x;
        result.weights[k] = cube.weights[k];
    }
    return result;
}

CubePlace place_in_cube(Vec3 p, bool odd) {
    const float u = odd ? 1 - p.x : p.x, v = p.y, w = p.z;
    CubePlace place;
    if (u + v + w > 2) {
        place = {{7, 6, 5, 3}, {u + v + w - 2, 1 - u, 1 - v, 1 - w}};
    } else if (u - v - w > 0) {
        place = {{1, 3, 5, 0}, {u - v - w, v, w, 1 - u}};
    } else if (v - u - w > 0) {
        place = {{2, 3, 6, 0}, {v - u - w, u, w, 1 - v}};
    } else if (w - u - v > 0) {
        place = {{4, 5, 6, 0}, {w - u - v, u, v, 1 - w}};
    } else {
        place = {{0, 3, 5, 6}, {1 - (u + v + w) / 2, (u + v - w) / 2, (u + w - v) / 2, (v + w - u) / 2}};
    }
    for (int k = 0; k < 4; ++k) {
        place.corners[k] ^= odd ? 1 : 0;
        place.weights[k] = std::max(place.weights[k], 0.0F);
    }
    return place;
}

}  // namespace gg
