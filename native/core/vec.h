// Vectors, boxes and affine maps. The only place that includes GLM.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>
#include <limits>

namespace gg {

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using Vec3d = glm::dvec3;
using Mat3 = glm::mat3;
using Rgb = glm::vec3;  // scene-linear, Rec.709 primaries

using glm::cross;
using glm::dot;
using glm::length;

inline constexpr float kPi = 3.14159265358979323846F;
inline constexpr float kInfinity = std::numeric_limits<float>::infinity();

[[nodiscard]] inline float length_squared(Vec3 v) {
    return dot(v, v);
}

// Zero stays zero: callers need no special case for degenerate input.
[[nodiscard]] inline Vec3 normalize_or_zero(Vec3 v) {
    const float squared = length_squared(v);
    return squared > 0 ? v / std::sqrt(squared) : Vec3(0);
}

// Relative luminance of a scene-linear Rec.709 colour [ITU-R BT.709].
[[nodiscard]] inline float luminance(Rgb c) {
    return 0.2126F * c.r + 0.7152F * c.g + 0.0722F * c.b;
}

[[nodiscard]] inline float max_component(Vec3 v) {
    return std::max(v.x, std::max(v.y, v.z));
}
[[nodiscard]] inline bool is_finite(Vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

struct Box {
    Vec3 lower{kInfinity};
    Vec3 upper{-kInfinity};

    void extend(Vec3 p) {
        lower = glm::min(lower, p);
        upper = glm::max(upper, p);
    }
    void extend(const Box& b) {
        lower = glm::min(lower, b.lower);
        upper = glm::max(upper, b.upper);
    }
    [[nodiscard]] bool empty() const { return !(lower.x <= upper.x && lower.y <= upper.y && lower.z <= upper.z); }
    [[nodiscard]] Vec3 center() const { return 0.5F * (lower + upper); }
    [[nodiscard]] Vec3 extent() const { return upper - lower; }
    [[nodiscard]] float diameter() const { return empty() ? 0.0F : length(extent()); }
    [[nodiscard]] bool contains(Vec3 p) const {
        return glm::all(glm::lessThanEqual(lower, p)) && glm::all(glm::lessThanEqual(p, upper));
    }
    [[nodiscard]] bool contains(const Box& b) const { return contains(b.lower) && contains(b.upper); }
    [[nodiscard]] bool overlaps(const Box& b) const {
        return glm::all(glm::lessThanEqual(lower, b.upper)) && glm::all(glm::lessThanEqual(b.lower, upper));
    }
};

// p -> linear * p + translation.
struct Affine {
    Mat3 linear{1.0F};
    Vec3 translation{0.0F};

    [[nodiscard]] Vec3 point(Vec3 p) const { return linear * p + translation; }
    [[nodiscard]] Vec3 vector(Vec3 v) const { return linear * v; }
};

// Maps normals, unnormalised: the cofactor matrix, with the sign that keeps an outward normal outward under mirroring.
// Its length scales by the ratio of areas: |normal_matrix(M) (e1 x e2)| = |M e1 x M e2|.
[[nodiscard]] inline Mat3 normal_matrix(const Mat3& linear) {
    const Mat3 cofactor(cross(linear[1], linear[2]), cross(linear[2], linear[0]), cross(linear[0], linear[1]));
    return glm::determinant(linear) < 0 ? -cofactor : cofactor;
}

[[nodiscard]] inline Box transformed(const Box& box, const Affine& map) {
    Box result;
    for (int corner = 0; corner < 8; ++corner) {
        result.extend(map.point({corner & 1 ? box.upper.x : box.lower.x, corner & 2 ? box.upper.y : box.lower.y,
                                 corner & 4 ? box.upper.z : box.lower.z}));
    }
    return result;
}

// Two unit vectors that complete unit vector n to a right-handed frame [Duff et al. 2017, JCGT 6(1)].
struct Frame {
    Vec3 tangent, bitangent, normal;

    explicit Frame(Vec3 n) : tangent(0), bitangent(0), normal(n) {
        const float sign = std::copysign(1.0F, n.z);
        const float a = -1.0F / (sign + n.z);
        const float b = n.x * n.y * a;
        tangent = {1.0F + sign * n.x * n.x * a, sign * b, -sign * n.x};
        bitangent = {b, sign + n.y * n.y * a, -n.y};
    }
    [[nodiscard]] Vec3 to_world(Vec3 v) const { return v.x * tangent + v.y * bitangent + v.z * normal; }
};

}  // namespace gg
