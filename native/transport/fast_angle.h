// The angle of a sine and a cosine, inlined.
#pragma once

#include <cmath>

#include "core/wide.h"

namespace gg {

// atan2(sine, cosine) for a sine >= 0, in [0, pi]; relative error at most 3e-7. Not for both zero. T: float or Wide.
template <typename T>
[[nodiscard]] inline T fast_angle(const T& sine, const T& cosine) {
    const T side = abs(cosine);
    const T t = min(sine, side) / max(sine, side);
    const T u = t * t;
    // atan(t) / t as a polynomial of t^2 on [0, 1]: minimax by its relative error, which is 1.5e-8.
    T p = T(0.0028498906F);
    for (const float c :
         {-0.016068636F, 0.042691533F, -0.07504296F, 0.10640935F, -0.14203645F, 0.1999262F, -0.33333072F, 1.0F}) {
        p = p * u + c;
    }
    const T within = t * p;
    const T half = select(sine > side, T(0.5F * kPi - within), within);
    return select(cosine < T(0), T(kPi - half), half);
}

[[nodiscard]] inline double fast_angle(double sine, double cosine) {
    return std::atan2(sine, cosine);
}

}  // namespace gg
