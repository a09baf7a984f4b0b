#include "image/view_curves.h"

#include <algorithm>
#include <cmath>

namespace gg {

Rgb ViewCurves::operator()(Rgb pixel) const {
    constexpr float kLeastRange = 1e-5F;  // from black to white
    for (int k = 0; k < 3; ++k) {
        const Channel& channel = channels[static_cast<std::size_t>(k)];
        const float x = (pixel[k] - channel.black) / std::max(channel.white - channel.black, kLeastRange);
        if (x < lower) {
            pixel[k] = channel.values.front() + channel.slope_below * (x - lower);
        } else if (x > upper) {
            pixel[k] = channel.values.back() + channel.slope_above * (x - upper);
        } else {
            const auto last = static_cast<float>(channel.values.size() - 1);
            const float place = std::min((x - lower) / (upper - lower) * last, last);
            const std::size_t i = std::min(static_cast<std::size_t>(place), channel.values.size() - 2);
            pixel[k] = std::lerp(channel.values[i], channel.values[i + 1], place - static_cast<float>(i));
        }
    }
    return pixel;
}

}  // namespace gg
