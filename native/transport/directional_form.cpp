#include "transport/directional_form.h"

namespace gg {
namespace {

// beam_coefficients(n) = kBeamScale * form_basis(n).
constexpr std::array<float, kFormSize> kBeamScale{3.0F / 32,  1.0F / 2,   1.0F / 2,   1.0F / 2,   15.0F / 32,
                                                  15.0F / 32, 15.0F / 32, 15.0F / 16, 15.0F / 16, 15.0F / 16};

}  // namespace

void ReflectionOperator::add_face(Vec3 n, float area, Rgb reflectance) {
    const auto basis = form_basis(n);
    std::array<float, kMoments> products;
    std::size_t entry = 0;
    for (std::size_t row = 0; row < kFormSize; ++row) {
        for (std::size_t column = row; column < kFormSize; ++column) {
            products[entry++] = basis[row] * basis[column];
        }
    }
    for (int channel = 0; channel < 3; ++channel) {
        const float weight = area * reflectance[channel];
        for (std::size_t i = 0; i < kMoments; ++i) {
            moments_[channel][i] += weight * products[i];
        }
    }
}

ReflectionOperator& ReflectionOperator::operator+=(const ReflectionOperator& other) {
    for (int channel = 0; channel < 3; ++channel) {
        for (std::size_t i = 0; i < kMoments; ++i) {
            moments_[channel][i] += other.moments_[channel][i];
        }
    }
    return *this;
}

DirectionalForm ReflectionOperator::apply(const DirectionalForm& irradiance) const {
    DirectionalForm intensity;
    for (int channel = 0; channel < 3; ++channel) {
        std::array<float, kFormSize> in;
        for (std::size_t i = 0; i < kFormSize; ++i) {
            in[i] = irradiance.coefficients[i][channel];
        }
        std::array<float, kFormSize> out{};
        const float* moment = moments_[channel].data();
        for (std::size_t row = 0; row < kFormSize; ++row) {
            out[row] += *moment++ * in[row];
            for (std::size_t column = row + 1; column < kFormSize; ++column) {
                out[row] += *moment * in[column];
                out[column] += *moment++ * in[row];
            }
        }
        for (std::size_t i = 0; i < kFormSize; ++i) {
            intensity.coefficients[i][channel] = out[i] * kBeamScale[i] / kPi;
        }
    }
    return intensity;
}

Rgb ReflectionOperator::reflected_power(const DirectionalForm& irradiance) const {
    Rgb power(0.0F);
    for (int channel = 0; channel < 3; ++channel) {
        for (std::size_t i = 0; i < kFormSize; ++i) {
            power[channel] += moments_[channel][i] * irradiance.coefficients[i][channel];
        }
    }
    return power;
}

}  // namespace gg
