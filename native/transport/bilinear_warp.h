// Points of the unit square as dense as a bilinear function.
#pragma once

#include <array>
#include <cmath>

#include "core/vec.h"

namespace gg {

class BilinearWarp {
  public:
    // at: values of the function, all above zero, at (0, 0), (1, 0), (0, 1), (1, 1).
    explicit BilinearWarp(const std::array<float, 4>& at) : at_(at), mean_(0.25F * (at[0] + at[1] + at[2] + at[3])) {}

    // Uniform (u, v) in [0, 1]^2 are spread by density(); moves continuously with the values.
    [[nodiscard]] Vec2 place(float u, float v) const {
        const float y = linear(at_[0] + at_[1], at_[2] + at_[3], v);
        return {linear((1 - y) * at_[0] + y * at_[2], (1 - y) * at_[1] + y * at_[3], u), y};
    }
    // Its mean over the square is 1.
    [[nodiscard]] float density(Vec2 place) const {
        const float x = place.x, y = place.y;
        return ((1 - y) * ((1 - x) * at_[0] + x * at_[1]) + y * ((1 - x) * at_[2] + x * at_[3])) / mean_;
    }

  private:
    // The place at which the integral of the function that goes from a to b is the share u of the whole.
    static float linear(float a, float b, float u) {
        return u * (a + b) / (a + std::sqrt((1 - u) * a * a + u * b * b));
    }

    std::array<float, 4> at_;
    float mean_;
};

}  // namespace gg
