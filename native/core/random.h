// Numbers that look random but are functions of (stable id, sample, dimension) alone.
#pragma once

#include <array>
#include <cstdint>

#include "core/vec.h"

namespace gg {

// Finaliser of SplitMix64 [Steele et al. 2014]: every output bit depends on every input bit.
[[nodiscard]] constexpr std::uint64_t hash64(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15ULL;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
}

[[nodiscard]] constexpr std::uint64_t hash64(std::uint64_t a, std::uint64_t b) {
    return hash64(hash64(a) ^ b);
}

// [0, 1) from the upper 24 bits.
[[nodiscard]] constexpr float unit_float(std::uint64_t bits) {
    return static_cast<float>(bits >> 40) * 0x1p-24F;
}

// Additive recurrences with the generalised golden ratio of N dimensions, phi^(N+1) = phi + 1: every prefix is evenly
// spread and all one-dimensional projections are distinct [Roberts 2018, "The unreasonable effectiveness of quasirandom
// sequences"]. `seed` shifts the whole sequence on the torus. Two sequences with different seeds are shifted copies of
// each other: what shall be independent must be dimensions of one.
template <int N>
class AdditiveSequence {
  public:
    explicit AdditiveSequence(std::uint64_t seed) {
        for (int d = 0; d < N; ++d) {
            state_[d] = static_cast<std::uint32_t>(hash64(seed, static_cast<std::uint64_t>(d)) >> 32);
        }
    }

    // Sample `index`, dimension 0..N-1, in [0, 1).
    [[nodiscard]] float operator()(std::uint32_t index, int dimension) const {
        return static_cast<float>((state_[dimension] + (index + 1) * kStep[dimension]) >> 8) * 0x1p-24F;
    }

  private:
    // 2^32 / phi^(d+1)
    static constexpr std::array<std::uint32_t, N> kStep = [] {
        if constexpr (N == 4) {
            return std::array<std::uint32_t, 4>{3679390609U, 3152041523U, 2700274806U, 2313257605U};
        } else {
            static_assert(N == 6);
            return std::array<std::uint32_t, 6>{3859688306U, 3468523226U, 3117001274U,
                                                2801104767U, 2517223199U, 2262111973U};
        }
    }();
    std::array<std::uint32_t, N> state_{};
};

using Sequence4 = AdditiveSequence<4>;
using Sequence6 = AdditiveSequence<6>;

// Uniform point of the unit disk from the unit square, low distortion [Shirley and Chiu 1997].
[[nodiscard]] inline Vec2 square_to_disk(float u, float v) {
    const float a = 2 * u - 1;
    const float b = 2 * v - 1;
    if (a == 0 && b == 0) {
        return {0, 0};
    }
    const bool wide = std::abs(a) > std::abs(b);
    const float radius = wide ? a : b;
    const float angle = wide ? (kPi / 4) * (b / a) : (kPi / 2) - (kPi / 4) * (a / b);
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

// The point of the unit square that square_to_disk() takes there.
[[nodiscard]] inline Vec2 disk_to_square(Vec2 p) {
    const float radius = length(p);
    if (!(radius > 0)) {
        return {0.5F, 0.5F};
    }
    const bool wide = std::abs(p.x) > std::abs(p.y);
    const float large = std::copysign(radius, wide ? p.x : p.y);
    const float small = large * (4 / kPi) * std::atan(wide ? p.y / p.x : p.x / p.y);
    return 0.5F + 0.5F * (wide ? Vec2(large, small) : Vec2(small, large));
}

// Direction of the hemisphere around +z from the unit square, its density the cosine over pi: a disk point lifted up.
[[nodiscard]] inline Vec3 square_to_cosine_hemisphere(float u, float v) {
    const Vec2 disk = square_to_disk(u, v);
    return {disk, std::sqrt(std::max(0.0F, 1 - dot(disk, disk)))};
}

// Uniform barycentric weights (of corners 0, 1, 2) from the unit square, low distortion [Heitz 2019].
[[nodiscard]] inline Vec3 square_to_triangle(float u, float v) {
    if (v > u) {
        u *= 0.5F;
        v -= u;
    } else {
        v *= 0.5F;
        u -= v;
    }
    return {1 - u - v, u, v};
}

}  // namespace gg
