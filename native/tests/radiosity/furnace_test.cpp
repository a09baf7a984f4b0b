// In a closed room where every face has reflectance r and emits e, every radiosity is e / (1 - r), whatever stands in
// it. Nothing averages out: light that is counted twice or lost shows at once, and the more the brighter the room.
#include <gtest/gtest.h>

#include <string>

#include "support/law_scenes.h"
#include "support/solution_measures.h"

namespace gg::test {
namespace {

struct Furnace {
    float reflectance;
    bool furnished;
    float quality;
    double tolerance;       // of the mean radiosity of any object, share of its true value
    double leaf_tolerance;  // of any leaf's
};

class FurnaceLaw : public testing::TestWithParam<Furnace> {};

TEST_P(FurnaceLaw, radiosity_is_emission_over_one_minus_reflectance) {
    const Furnace& law = GetParam();
    Prepared prepared(furnace(law.reflectance, law.furnished));
    const auto solution = prepared.solve(law.quality);
    const double expected = 1.0 / (1.0 - law.reflectance);
    for (std::uint32_t instance = 0; instance < prepared.scene.instances.size(); ++instance) {
        const FaceMeans means = means_of_instance(*solution, instance);
        EXPECT_NEAR(luminance_of(means.radiosity) / expected, 1, law.tolerance) << "instance " << instance;
        EXPECT_GT(means.least / expected, 1 - law.leaf_tolerance) << "instance " << instance;
        EXPECT_LT(means.most / expected, 1 + law.leaf_tolerance) << "instance " << instance;
    }
}

TEST_P(FurnaceLaw, what_is_emitted_is_absorbed) {
    const Furnace& law = GetParam();
    Prepared prepared(furnace(law.reflectance, law.furnished));
    const auto solution = prepared.solve(law.quality);
    double emitted = 0, absorbed = 0;
    for (std::uint32_t instance = 0; instance < prepared.scene.instances.size(); ++instance) {
        const FaceMeans means = means_of_instance(*solution, instance);
        emitted += means.area;
        absorbed += means.area * (1 - law.reflectance) * luminance_of(means.radiosity);
    }
    EXPECT_NEAR(absorbed / emitted, 1, law.tolerance);
}

std::string name_of(const testing::TestParamInfo<Furnace>& info) {
    const Furnace& law = info.param;
    return std::string(law.furnished ? "furnished" : "empty") + (law.reflectance > 0.6F ? "_bright" : "_grey") +
           (law.quality < 0.01F ? "_fine" : "_coarse");
}

INSTANTIATE_TEST_SUITE_P(
    Rooms, FurnaceLaw,
    testing::Values(Furnace{0.5F, false, 0.02F, 0.01, 0.05}, Furnace{0.8F, false, 0.02F, 0.01, 0.05},
                    Furnace{0.5F, false, 0.005F, 0.01, 0.05}, Furnace{0.8F, false, 0.005F, 0.02, 0.16},
                    Furnace{0.5F, true, 0.02F, 0.025, 0.35}, Furnace{0.8F, true, 0.02F, 0.05, 0.7},
                    Furnace{0.5F, true, 0.005F, 0.025, 0.25}, Furnace{0.8F, true, 0.005F, 0.05, 0.5}),
    name_of);

}  // namespace
}  // namespace gg::test
