// Repeatable random vectors and polygons for the tests of the transport layer.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/random.h"
#include "core/vec.h"

namespace gg::test {

class Random {
  public:
    explicit Random(std::uint64_t seed) : seed_(seed) {}

    // Uniform in [lower, upper).
    double uniform(double lower = 0, double upper = 1) {
        const double unit = static_cast<double>(hash64(seed_, count_++) >> 11) * 0x1p-53;
        return lower + (upper - lower) * unit;
    }
    // Uniform on the unit sphere.
    Vec3d direction() {
        const double z = uniform(-1, 1);
        const double angle = uniform(0, 2 * static_cast<double>(kPi));
        const double radius = std::sqrt(1 - z * z);
        return {radius * std::cos(angle), radius * std::sin(angle), z};
    }
    // Corners on a circle of that radius in a random plane: convex, and planar to rounding.
    std::vector<Vec3d> polygon(Vec3d center, double radius, int corners) {
        const Vec3d normal = direction();
        const Vec3d u = glm::normalize(glm::cross(normal, direction()));
        const Vec3d v = glm::cross(normal, u);
        const double start = uniform(0, 6);
        std::vector<Vec3d> result;
        for (int i = 0; i < corners; ++i) {
            const double angle = start + (i + uniform(0, 0.8)) * 2 * static_cast<double>(kPi) / corners;
            result.push_back(center + radius * (std::cos(angle) * u + std::sin(angle) * v));
        }
        return result;
    }

  private:
    std::uint64_t seed_;
    std::uint64_t count_ = 0;
};

}  // namespace gg::test
