// Light that depends on direction, as a quadratic form: E(n) = a0 + a1.n + n^T A2 n, ten coefficients per channel.
// The clamped cosine is replaced by its expansion up to second order, max(0, c) ~ 3/32 + c/2 + 15/32 c^2, which keeps
// the mean over the sphere and the first two moments. Error over random directions: rms 0.036 (0.034 once clamped at
// 0), largest 0.094 of the beam. One struct serves both ways: irradiance as a function of the receiver's normal [W/m2],
// and intensity of a group of faces as a function of the direction towards the receiver [W/sr].
#pragma once

#include <array>
#include <cstddef>

#include "core/vec.h"

namespace gg {

inline constexpr std::size_t kFormSize = 10;

// 1, x, y, z, xx, yy, zz, xy, xz, yz of unit vector n.
[[nodiscard]] inline std::array<float, kFormSize> form_basis(Vec3 n) {
    return {1.0F, n.x, n.y, n.z, n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.x * n.z, n.y * n.z};
}

// The clamped cosine around unit vector d: dot(beam_coefficients(d), form_basis(n)) ~ max(0, n.d), symmetric in n, d.
[[nodiscard]] inline std::array<float, kFormSize> beam_coefficients(Vec3 d) {
    constexpr float k0 = 3.0F / 32.0F;
    constexpr float k1 = 1.0F / 2.0F;
    constexpr float k2 = 15.0F / 32.0F;
    return {k0,
            k1 * d.x,
            k1 * d.y,
            k1 * d.z,
            k2 * d.x * d.x,
            k2 * d.y * d.y,
            k2 * d.z * d.z,
            2 * k2 * d.x * d.y,
            2 * k2 * d.x * d.z,
            2 * k2 * d.y * d.z};
}

struct DirectionalForm {
    std::array<Rgb, kFormSize> coefficients{};  // of form_basis

    DirectionalForm& operator+=(const DirectionalForm& other) {
        for (std::size_t i = 0; i < kFormSize; ++i) {
            coefficients[i] += other.coefficients[i];
        }
        return *this;
    }
    DirectionalForm& operator*=(Rgb factor) {
        for (Rgb& coefficient : coefficients) {
            coefficient *= factor;
        }
        return *this;
    }
    DirectionalForm& operator*=(float factor) { return *this *= Rgb(factor); }
};

[[nodiscard]] inline DirectionalForm operator+(DirectionalForm a, const DirectionalForm& b) {
    return a += b;
}
[[nodiscard]] inline DirectionalForm operator*(DirectionalForm form, float factor) {
    return form *= factor;
}
[[nodiscard]] inline DirectionalForm operator*(float factor, DirectionalForm form) {
    return form *= factor;
}

// Adds light that arrives from unit direction d, `irradiance` [W/m2] on a plane that faces d.
inline void add_beam(DirectionalForm& form, Rgb irradiance, Vec3 d) {
    const auto beam = beam_coefficients(d);
    for (std::size_t i = 0; i < kFormSize; ++i) {
        form.coefficients[i] += irradiance * beam[i];
    }
}

// Adds light of even radiance from a cone of directions around d. `mean_direction` is the mean of its unit directions:
// d times (1 + cos of the half angle) / 2, so a unit vector is a beam. `irradiance` is what a beam of the same solid
// angle would give a facing plane, pi times radiance times solid angle over pi. Zeroth and first moment are exact; the
// second is that of the cone, (1 + c + c^2) / 3 along the axis for c the cosine of the half angle, the rest evenly
// across.
inline void add_cone(DirectionalForm& form, Rgb irradiance, Vec3 mean_direction) {
    const float mean = length(mean_direction);
    const Vec3 d = mean > 0 ? mean_direction / mean : Vec3(0.0F, 0.0F, 1.0F);
    const float c = 2 * mean - 1;
    const float along = std::max((1 + c + c * c) / 3, 1.0F / 3.0F);
    const float across = 0.5F * (1 - along);
    auto beam = beam_coefficients(d);
    for (std::size_t i = 1; i < 4; ++i) {
        beam[i] *= mean;
    }
    for (std::size_t i = 4; i < kFormSize; ++i) {
        beam[i] *= along - across;
    }
    beam[0] += 15.0F / 32.0F * across;
    for (std::size_t i = 0; i < kFormSize; ++i) {
        form.coefficients[i] += irradiance * beam[i];
    }
}

// Adds a one-sided face with unit normal n to an intensity form; radiance times area [W/sr]. The same sum as add_beam.
inline void add_face(DirectionalForm& form, Rgb radiance_times_area, Vec3 n) {
    add_beam(form, radiance_times_area, n);
}

// The form itself: slightly negative where the expansion undershoots.
[[nodiscard]] inline Rgb evaluate(const DirectionalForm& form, Vec3 direction) {
    const auto basis = form_basis(direction);
    Rgb sum(0.0F);
    for (std::size_t i = 0; i < kFormSize; ++i) {
        sum += form.coefficients[i] * basis[i];
    }
    return sum;
}

[[nodiscard]] inline Rgb evaluate_clamped(const DirectionalForm& form, Vec3 direction) {
    return glm::max(evaluate(form, direction), Rgb(0.0F));
}

// How a group of diffuse faces turns irradiance into outgoing intensity: a linear map from form to form, so that a
// cluster reflects without visiting its faces. With m(n) = form_basis(n), the map is diag(k) S / pi where
// S = sum_i A_i rho_i m(n_i) m(n_i)^T is symmetric (55 numbers a channel) and k scales basis to beam coefficients.
// Faces see the unclamped form, since only that is linear. Operators of disjoint groups add.
class ReflectionOperator {
  public:
    // One side of a face: unit normal, area [m2], reflectance 0..1.
    void add_face(Vec3 n, float area, Rgb reflectance);
    ReflectionOperator& operator+=(const ReflectionOperator& other);

    // Irradiance form [W/m2] to intensity form [W/sr]: sum_i (rho_i A_i / pi) E(n_i) max(0, n_i.w) as a form in w.
    [[nodiscard]] DirectionalForm apply(const DirectionalForm& irradiance) const;

    // Reflected power [W]: sum_i A_i rho_i E(n_i).
    [[nodiscard]] Rgb reflected_power(const DirectionalForm& irradiance) const;

  private:
    static constexpr std::size_t kMoments = kFormSize * (kFormSize + 1) / 2;
    // Per channel the upper triangle of S [m2], row after row; row 0 is also the row of the power.
    std::array<std::array<float, kMoments>, 3> moments_{};
};

}  // namespace gg
