#include "oracles/full_matrix_radiosity.h"

#include <cmath>

#include "oracles/form_factor_oracle.h"
#include "transport/form_factor.h"

namespace gg::oracle {
namespace {

struct GaussPoint {
    double position, weight;  // on [0, 1]
};

std::vector<GaussPoint> gauss_points(int count) {
    if (count == 2) {
        const double offset = 0.5 / std::sqrt(3.0);
        return {{0.5 - offset, 0.5}, {0.5 + offset, 0.5}};
    }
    const double offset = 0.5 * std::sqrt(0.6);
    return {{0.5 - offset, 5.0 / 18}, {0.5, 8.0 / 18}, {0.5 + offset, 5.0 / 18}};
}

std::array<Vec3d, 4> corners_of(const Patch& patch) {
    return {patch.corner, patch.corner + patch.u, patch.corner + patch.u + patch.v, patch.corner + patch.v};
}

Vec3d normal_of(const Patch& patch) {
    return glm::normalize(glm::cross(patch.u, patch.v));
}

bool in_front(Vec3d x, const Patch& patch) {
    return glm::dot(x - patch.corner, normal_of(patch)) > 1e-12;
}

bool all_behind(const Patch& patch, const Patch& of) {
    for (const Vec3d& corner : corners_of(patch)) {
        if (in_front(corner, of)) {
            return false;
        }
    }
    return true;
}

double seen_from(Vec3d x, Vec3d normal, std::span<const Patch> cells, std::span<const OracleTriangle> occluders) {
    double sum = 0;
    for (const Patch& cell : cells) {
        const auto corners = corners_of(cell);
        if (in_front(x, cell) &&
            (occluders.empty() || !is_blocked(x, cell.corner + 0.5 * (cell.u + cell.v), occluders))) {
            sum += point_to_polygon(x, normal, std::span<const Vec3d>(corners));
        }
    }
    return sum;
}

double form_factor(const Patch& receiver, const Patch& sender, std::span<const Patch> cells,
                   std::span<const OracleTriangle> occluders, int points) {
    if (all_behind(receiver, sender) || all_behind(sender, receiver)) {
        return 0;
    }
    if (points == 0) {
        return area_to_polygon(receiver.corner, receiver.u, receiver.v, corners_of(sender));
    }
    const Vec3d normal = normal_of(receiver);
    double sum = 0;
    for (const GaussPoint& a : gauss_points(points)) {
        for (const GaussPoint& b : gauss_points(points)) {
            const Vec3d x = receiver.corner + a.position * receiver.u + b.position * receiver.v;
            sum += a.weight * b.weight * seen_from(x, normal, cells, occluders);
        }
    }
    return sum;
}

}  // namespace

std::vector<Patch> subdivide(const Patch& whole, int count) {
    std::vector<Patch> parts;
    for (int row = 0; row < count; ++row) {
        for (int column = 0; column < count; ++column) {
            Patch part = whole;
            part.u /= count;
            part.v /= count;
            part.corner += static_cast<double>(column) * part.u + static_cast<double>(row) * part.v;
            parts.push_back(part);
        }
    }
    return parts;
}

std::vector<OracleTriangle> triangles_of(std::span<const Patch> patches) {
    std::vector<OracleTriangle> triangles;
    for (const Patch& patch : patches) {
        const auto c = corners_of(patch);
        triangles.push_back({c[0], c[1], c[2]});
        triangles.push_back({c[0], c[2], c[3]});
    }
    return triangles;
}

bool is_blocked(Vec3d a, Vec3d b, std::span<const OracleTriangle> occluders) {
    constexpr double kEnd = 1e-6;  // share of the segment at either end that does not count
    const Vec3d direction = b - a;
    for (const OracleTriangle& triangle : occluders) {
        const Vec3d edge1 = triangle[1] - triangle[0];
        const Vec3d edge2 = triangle[2] - triangle[0];
        const Vec3d p = glm::cross(direction, edge2);
        const double determinant = glm::dot(edge1, p);
        if (std::abs(determinant) < 1e-12) {
            continue;
        }
        const Vec3d s = a - triangle[0];
        const Vec3d q = glm::cross(s, edge1);
        const double u = glm::dot(s, p) / determinant;
        const double v = glm::dot(direction, q) / determinant;
        const double t = glm::dot(edge2, q) / determinant;
        if (u >= 0 && v >= 0 && u + v <= 1 && t > kEnd && t < 1 - kEnd) {
            return true;
        }
    }
    return false;
}

std::vector<double> form_factor_matrix(std::span<const Patch> patches, std::span<const OracleTriangle> occluders,
                                       const FormFactorSettings& settings) {
    const std::size_t n = patches.size();
    std::vector<std::vector<Patch>> cells;
    for (const Patch& patch : patches) {
        cells.push_back(subdivide(patch, settings.sender_cells));
    }
    std::vector<double> matrix(n * n);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            matrix[i * n + j] = form_factor(patches[i], patches[j], cells[j], occluders, settings.receiver_points);
        }
    }
    return matrix;
}

std::vector<double> solve_radiosity(std::span<const Patch> patches, std::span<const double> form_factors) {
    const std::size_t n = patches.size();
    std::vector<double> matrix(n * n), result(n);
    for (std::size_t i = 0; i < n; ++i) {
        result[i] = patches[i].emission;
        for (std::size_t j = 0; j < n; ++j) {
            matrix[i * n + j] = (i == j ? 1 : 0) - patches[i].reflectance * form_factors[i * n + j];
        }
    }
    // Diagonally dominant since rho < 1: no pivots needed.
    for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t i = k + 1; i < n; ++i) {
            const double factor = matrix[i * n + k] / matrix[k * n + k];
            if (factor == 0) {
                continue;
            }
            for (std::size_t j = k; j < n; ++j) {
                matrix[i * n + j] -= factor * matrix[k * n + j];
            }
            result[i] -= factor * result[k];
        }
    }
    for (std::size_t k = n; k-- > 0;) {
        for (std::size_t j = k + 1; j < n; ++j) {
            result[k] -= matrix[k * n + j] * result[j];
        }
        result[k] /= matrix[k * n + k];
    }
    return result;
}

}  // namespace gg::oracle
