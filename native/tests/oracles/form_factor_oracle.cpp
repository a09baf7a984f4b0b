#include "oracles/form_factor_oracle.h"

#include <cmath>
#include <numbers>

#include "transport/form_factor.h"

namespace gg::oracle {
namespace {

constexpr double kPiD = std::numbers::pi;

struct Node {
    double position, weight;  // on [0, 1]
};

std::vector<Node> double_exponential_nodes() {
    constexpr double kStep = 0.08;
    std::vector<Node> nodes;
    for (int i = -40; i <= 40; ++i) {
        const double t = kStep * i;
        const double inner = kPiD / 2 * std::sinh(t);
        const double cosh_inner = std::cosh(inner);
        nodes.push_back({0.5 * (1 + std::tanh(inner)), 0.25 * kStep * kPiD * std::cosh(t) / (cosh_inner * cosh_inner)});
    }
    return nodes;
}

}  // namespace

double parallel_rectangles(double a, double b, double c) {
    const double x = a / c;
    const double y = b / c;
    const double px = 1 + x * x;
    const double py = 1 + y * y;
    return 2 / (kPiD * x * y) *
           (0.5 * std::log(px * py / (px + y * y)) + x * std::sqrt(py) * std::atan(x / std::sqrt(py)) +
            y * std::sqrt(px) * std::atan(y / std::sqrt(px)) - x * std::atan(x) - y * std::atan(y));
}

double perpendicular_rectangles(double w, double h, double l) {
    const double ww = (w / l) * (w / l);
    const double hh = (h / l) * (h / l);
    const double diagonal = std::sqrt(ww + hh);
    const double logs = std::log((1 + ww) * (1 + hh) / (1 + ww + hh)) +
                        ww * std::log(ww * (1 + ww + hh) / ((1 + ww) * (ww + hh))) +
                        hh * std::log(hh * (1 + ww + hh) / ((1 + hh) * (ww + hh)));
    return (w / l * std::atan(l / w) + h / l * std::atan(l / h) - diagonal * std::atan(1 / diagonal) + 0.25 * logs) /
           (kPiD * w / l);
}

double coaxial_disks(double r1, double r2, double h) {
    const double s = 1 + (1 + (r2 / h) * (r2 / h)) / ((r1 / h) * (r1 / h));
    return 0.5 * (s - std::sqrt(s * s - 4 * (r2 / r1) * (r2 / r1)));
}

std::vector<Vec3d> disk_polygon(double radius, double z, int corners) {
    const double step = 2 * kPiD / corners;
    const double outer = radius * std::sqrt(step / std::sin(step));
    std::vector<Vec3d> polygon;
    for (int i = 0; i < corners; ++i) {
        polygon.push_back({outer * std::cos(i * step), outer * std::sin(i * step), z});
    }
    return polygon;
}

double area_to_polygon(Vec3d corner, Vec3d u, Vec3d v, std::span<const Vec3d> polygon) {
    const Vec3d n = glm::normalize(glm::cross(u, v));
    const auto nodes = double_exponential_nodes();
    double sum = 0;
    for (const Node& a : nodes) {
        for (const Node& b : nodes) {
            sum += a.weight * b.weight * point_to_polygon(corner + a.position * u + b.position * v, n, polygon);
        }
    }
    return sum;
}

double disk_to_polygon(double radius, std::span<const Vec3d> polygon) {
    double sum = 0;
    for (const Node& node : double_exponential_nodes()) {
        // Uniform in area: the radius squared is uniform.
        const Vec3d x{radius * std::sqrt(node.position), 0, 0};
        sum += node.weight * point_to_polygon(x, Vec3d(0, 0, 1), polygon);
    }
    return sum;
}

double counted_form_factor(Vec3d x, Vec3d n, std::span<const Vec3d> polygon, std::uint32_t rays) {
    const Vec3d helper = std::abs(n.x) < 0.5 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
    const Vec3d tangent = glm::normalize(glm::cross(helper, n));
    const Vec3d bitangent = glm::cross(n, tangent);
    const Vec3d plane = glm::cross(polygon[1] - polygon[0], polygon[2] - polygon[0]);
    std::uint32_t hits = 0;
    for (std::uint32_t i = 0; i < rays; ++i) {
        // Additive recurrence of the plastic number, on the disk: the projection of cosine-distributed directions.
        const double radius_squared = std::fmod(0.5 + 0.7548776662466927 * i, 1.0);
        const double angle = 2 * kPiD * std::fmod(0.5 + 0.5698402909980532 * i, 1.0);
        const double radius = std::sqrt(radius_squared);
        const Vec3d direction = radius * std::cos(angle) * tangent + radius * std::sin(angle) * bitangent +
                                std::sqrt(1 - radius_squared) * n;
        const double slope = glm::dot(plane, direction);
        const double t = glm::dot(plane, polygon[0] - x) / slope;
        if (!(t > 0)) {
            continue;
        }
        const Vec3d hit = x + t * direction;
        bool inside = true;
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const Vec3d& a = polygon[k];
            const Vec3d& b = polygon[(k + 1) % polygon.size()];
            inside = inside && glm::dot(glm::cross(b - a, hit - a), plane) >= 0;
        }
        hits += inside ? 1 : 0;
    }
    return static_cast<double>(hits) / rays;
}

}  // namespace gg::oracle
