// Several floats at a time. Formulas that are wanted for one value and for many are templates over float and Wide.
#pragma once

#include <experimental/simd>

#include "core/vec.h"

namespace gg {

using Wide = std::experimental::native_simd<float>;
using WideMask = Wide::mask_type;
inline constexpr std::size_t kLanes = Wide::size();

// Beside the ones for Wide, which are found by argument.
using std::abs, std::clamp, std::copysign, std::cos, std::max, std::min, std::sin, std::sqrt;

template <typename T>
[[nodiscard]] inline T select(bool which, T yes, T no) {
    return which ? yes : no;
}
[[nodiscard]] inline Wide select(WideMask which, const Wide& yes, Wide no) {
    where(which, no) = yes;
    return no;
}

[[nodiscard]] inline Wide load(const float* from) {
    return Wide(from, std::experimental::element_aligned);
}

struct WideVec3 {
    using value_type = Wide;

    Wide x = 0, y = 0, z = 0;

    WideVec3() = default;
    WideVec3(const Wide& a, const Wide& b, const Wide& c) : x(a), y(b), z(c) {}
    // The same in all lanes.
    explicit WideVec3(Vec3 v) : x(v.x), y(v.y), z(v.z) {}

    [[nodiscard]] Vec3 lane(std::size_t index) const { return {x[index], y[index], z[index]}; }
    void set(std::size_t lane, Vec3 v) {
        x[lane] = v.x;
        y[lane] = v.y;
        z[lane] = v.z;
    }
};

[[nodiscard]] inline WideVec3 operator+(const WideVec3& a, const WideVec3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
[[nodiscard]] inline WideVec3 operator-(const WideVec3& a, const WideVec3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[nodiscard]] inline WideVec3 operator*(const Wide& s, const WideVec3& v) {
    return {s * v.x, s * v.y, s * v.z};
}
[[nodiscard]] inline Wide dot(const WideVec3& a, const WideVec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[nodiscard]] inline WideVec3 cross(const WideVec3& a, const WideVec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

[[nodiscard]] inline WideVec3 select(WideMask which, const WideVec3& yes, const WideVec3& no) {
    return {select(which, yes.x, no.x), select(which, yes.y, no.y), select(which, yes.z, no.z)};
}
[[nodiscard]] inline Wide luminance(const WideVec3& c) {
    return 0.2126F * c.x + 0.7152F * c.y + 0.0722F * c.z;
}

struct WideVec2 {
    Wide x = 0, y = 0;
};

template <typename T>
struct VectorsOf;
template <>
struct VectorsOf<float> {
    using Two = Vec2;
    using Three = Vec3;
};
template <>
struct VectorsOf<Wide> {
    using Two = WideVec2;
    using Three = WideVec3;
};
template <typename T>
using Vec2Of = typename VectorsOf<T>::Two;
template <typename T>
using Vec3Of = typename VectorsOf<T>::Three;

}  // namespace gg
