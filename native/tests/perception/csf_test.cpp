#include "perception/csf.h"

#include <gtest/gtest.h>

#include <utility>

namespace gg::test {
namespace {

// The largest value and its frequency.
std::pair<float, float> peak(float adaptation) {
    std::pair<float, float> best{0, 0};
    for (float f = 0.1F; f < 30; f += 0.001F) {
        best = std::max(best, {contrast_sensitivity(f, adaptation), f});
    }
    return best;
}

TEST(Csf, has_known_peaks) {
    for (const auto& [adaptation, value, frequency] :
         {std::tuple(100.0F, 525.15F, 3.248F), {10.0F, 401.8F, 2.52F}, {1.0F, 262.6F, 1.80F}}) {
        EXPECT_NEAR(peak(adaptation).first, value, 0.06F) << adaptation;
        EXPECT_NEAR(peak(adaptation).second, frequency, 0.006F) << adaptation;
    }
    EXPECT_NEAR(peak(100).first, kPeakSensitivity, 0.01F);
}

// Where the published elevations by frequency are the peak over these.
TEST(Csf, has_known_values) {
    for (const auto& [frequency, factor] :
         {std::pair(1.0F, 1.60F), {2.0F, 1.10F}, {4.0F, 1.02F}, {8.0F, 1.57F}, {16.0F, 4.21F}, {19.8F, 6.58F}}) {
        EXPECT_NEAR(kPeakSensitivity / contrast_sensitivity(frequency, 100), factor, 0.006F) << frequency;
    }
}

}  // namespace
}  // namespace gg::test
