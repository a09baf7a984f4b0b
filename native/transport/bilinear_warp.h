// Points of the unit square as dense as a bilinear function.
#pragma once

#include <array>

#include "core/wide.h"

namespace gg {

// T: float, or Wide for several functions at a time.
template <typename T>
class BilinearWarpOf {
  public:
    // Even.
    BilinearWarpOf() : at_{T(1), T(1), T(1), T(1)}, mean_(1) {}
    // at: values of the function, all above zero, at (0, 0), (1, 0), (0, 1), (1, 1).
    explicit BilinearWarpOf(const std::array<T, 4>& at) : at_(at), mean_(T(0.25F) * (at[0] + at[1] + at[2] + at[3])) {}

    // Uniform (u, v) in [0, 1]^2 are spread by density(); moves continuously with the values.
    [[nodiscard]] Vec2Of<T> place(const T& u, const T& v) const {
        const T y = linear(at_[0] + at_[1], at_[2] + at_[3], v);
        return {linear((T(1) - y) * at_[0] + y * at_[2], (T(1) - y) * at_[1] + y * at_[3], u), y};
    }
    // Its mean over the square is 1.
    [[nodiscard]] T density(const Vec2Of<T>& place) const {
        const T x = place.x, y = place.y;
        return ((T(1) - y) * ((T(1) - x) * at_[0] + x * at_[1]) + y * ((T(1) - x) * at_[2] + x * at_[3])) / mean_;
    }

    void set(std::size_t lane, const BilinearWarpOf<float>& warp) {
        for (std::size_t k = 0; k < 4; ++k) {
            at_[k][lane] = warp.at_[k];
        }
        mean_[lane] = warp.mean_;
    }

  private:
    template <typename>
    friend class BilinearWarpOf;

    // The place at which the integral of the function that goes from a to b is the share u of the whole.
    static T linear(const T& a, const T& b, const T& u) {
        return u * (a + b) / (a + sqrt((T(1) - u) * a * a + u * b * b));
    }

    std::array<T, 4> at_;
    T mean_;
};

using BilinearWarp = BilinearWarpOf<float>;

}  // namespace gg
