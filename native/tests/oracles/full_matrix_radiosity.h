// Slow truth for whole solutions: constant elements, every pair linked, the full matrix solved [GORAL et al. 1984].
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/vec.h"

namespace gg::oracle {

// One-sided parallelogram corner, corner + u, corner + v; its front is where u x v points.
struct Patch {
    Vec3d corner{0.0}, u{0.0}, v{0.0};     // m
    double reflectance = 0, emission = 0;  // 0..1, W/m2

    [[nodiscard]] double area() const { return glm::length(glm::cross(u, v)); }
};

using OracleTriangle = std::array<Vec3d, 3>;

// count x count patches that cover the whole one, row by row.
[[nodiscard]] std::vector<Patch> subdivide(const Patch& whole, int count);

// Two triangles per patch.
[[nodiscard]] std::vector<OracleTriangle> triangles_of(std::span<const Patch> patches);

// Whether a triangle crosses the open segment from a to b, both sides [MOELLER-TRUMBORE].
[[nodiscard]] bool is_blocked(Vec3d a, Vec3d b, std::span<const OracleTriangle> occluders);

struct FormFactorSettings {
    int receiver_points = 3;  // 2 or 3 Gauss points along each edge; 0: as many as give 1e-9 even along common edges
    int sender_cells = 1;     // along each edge; each cell is seen as a whole or not, where its middle is
};

// Row-major n x n: F[i * n + j] is the share of what leaves i that reaches j.
[[nodiscard]] std::vector<double> form_factor_matrix(std::span<const Patch> patches,
                                                     std::span<const OracleTriangle> occluders,
                                                     const FormFactorSettings& settings);

// B = E + rho F B by elimination, W/m2.
[[nodiscard]] std::vector<double> solve_radiosity(std::span<const Patch> patches, std::span<const double> form_factors);

}  // namespace gg::oracle
