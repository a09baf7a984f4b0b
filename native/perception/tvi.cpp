#include "perception/tvi.h"

#include <algorithm>
#include <cmath>

namespace gg {

namespace {

float log_threshold(float x) {
    if (x < -3.94F) {
        return -2.86F;
    }
    if (x < -1.44F) {
        return std::pow(0.405F * x + 1.6F, 2.18F) - 2.86F;
    }
    if (x < -0.0184F) {
        return x - 0.395F;
    }
    if (x < 1.9F) {
        return std::pow(0.249F * x + 0.65F, 2.7F) - 0.72F;
    }
    return x - 1.255F;
}

}  // namespace

float just_noticeable(float adaptation) {
    return std::pow(10.0F, log_threshold(std::log10(std::max(adaptation, kDarkestAdaptation))));
}

}  // namespace gg
