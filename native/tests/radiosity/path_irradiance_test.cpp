// The random walks that judge the solver, against what is known in closed form.
#include "oracles/path_irradiance.h"

#include <gtest/gtest.h>

#include "support/face_points.h"
#include "support/law_scenes.h"
#include "support/solution_measures.h"

namespace gg::test {
namespace {

// Over instances one by one: the root's faces, walls on both sides.
double arriving(const Prepared& prepared, std::uint32_t walks) {
    const Hierarchy hierarchy(prepared.scene, *prepared.colors, prepared.faces());
    const oracle::WalkedScene walked{prepared.scene, *prepared.colors, *prepared.tracer};
    const Node& root = hierarchy[kGeometryRoot];
    return FacePoints(hierarchy, root).area() * luminance_of(oracle::mean_irradiance(walked, hierarchy, root, walks));
}

TEST(PathIrradiance, of_a_furnace_is_emission_over_one_minus_reflectance) {
    const Prepared prepared(furnace(0.7F, true));
    const Hierarchy hierarchy(prepared.scene, *prepared.colors, prepared.faces());
    const oracle::WalkedScene walked{prepared.scene, *prepared.colors, *prepared.tracer};
    double sum = 0;
    constexpr std::uint32_t kWalks = 20000;
    for (std::uint32_t i = 0; i < kWalks; ++i) {
        sum += luminance_of(oracle::walked_irradiance(walked, {2, 1.5F, 0}, {0, 0, 1}, i)) / kWalks;
    }
    EXPECT_NEAR(sum * (1 - 0.7), 1, 0.02);
}

TEST(PathIrradiance, of_a_closed_room_absorbs_what_its_lamp_emits) {
    const Prepared prepared(lamp_room(0.6F));
    EXPECT_NEAR(0.4 * arriving(prepared, 100000) / lamp_power(prepared.scene), 1, 0.02);
}

TEST(PathIrradiance, of_the_open_is_that_of_the_sky) {
    SceneBuilder builder;
    builder.quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, builder.material(Rgb(0.5F)));
    builder.description.world = Rgb(3.0F);
    const Prepared prepared(builder.description);
    EXPECT_NEAR(arriving(prepared, 100), 2 * 3.0 * kPi, 1e-3);
}

}  // namespace
}  // namespace gg::test
