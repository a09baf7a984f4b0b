// What a lamp emits into a closed room is absorbed there, and what an integrating sphere holds is known in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/law_scenes.h"
#include "support/solution_measures.h"

namespace gg::test {
namespace {

struct Room {
    float reflectance, quality;
    double tolerance;
};

class ClosedRoom : public testing::TestWithParam<Room> {};

TEST_P(ClosedRoom, absorbs_what_its_lamp_emits) {
    const Room& room = GetParam();
    Prepared prepared(lamp_room(room.reflectance));
    const auto solution = prepared.solve(room.quality);
    const double absorbed = (1 - room.reflectance) * arriving_power(*solution);
    EXPECT_NEAR(absorbed / lamp_power(prepared.scene), 1, room.tolerance);
}

std::string name_of(const testing::TestParamInfo<Room>& info) {
    const std::string percent = std::to_string(std::lround(100 * info.param.reflectance));
    return "reflecting_" + percent + (info.param.quality < 0.01F ? "_percent_fine" : "_percent_coarse");
}

// Errors are weighed by what can be seen of them, so a black room is solved more coarsely.
INSTANTIATE_TEST_SUITE_P(Rooms, ClosedRoom,
                         testing::Values(Room{0.0F, 0.005F, 0.06}, Room{0.3F, 0.02F, 0.03}, Room{0.3F, 0.005F, 0.01},
                                         Room{0.6F, 0.02F, 0.03}, Room{0.6F, 0.005F, 0.02}, Room{0.8F, 0.02F, 0.04},
                                         Room{0.8F, 0.005F, 0.02}),
                         name_of);

// Upper and lower half differ: H = (sum A_j E_j / A) / (1 - sum A_j rho_j / A) falls on every face of a sphere,
// whatever its own reflectance and emission, and B_j = E_j + rho_j H [integrating sphere].
TEST(EnergyBalance, integrating_sphere_is_lit_evenly) {
    SceneBuilder builder;
    const std::uint32_t bright = builder.material(Rgb(0.8F, 0.5F, 0.2F));
    const std::uint32_t glowing = builder.material(Rgb(0.4F, 0.3F, 0.6F), Rgb(2 / kPi));
    builder.sphere(Vec3(0.0F), 2, 24, bright, true);
    MeshDescription& mesh = builder.description.meshes[0];
    for (std::size_t triangle = 0; triangle < mesh.triangle_vertices.size() / 3; ++triangle) {
        const bool below = mesh.positions[mesh.triangle_vertices[3 * triangle]].z +
                               mesh.positions[mesh.triangle_vertices[3 * triangle + 1]].z +
                               mesh.positions[mesh.triangle_vertices[3 * triangle + 2]].z <
                           0;
        mesh.triangle_slots.push_back(below ? 1 : 0);
    }
    builder.description.material_lists[0] = {bright, glowing};
    Prepared prepared(builder.description);
    const auto solution = prepared.solve(0.005F);
    const Vec3d mean_reflectance = 0.5 * (Vec3d(0.8, 0.5, 0.2) + Vec3d(0.4, 0.3, 0.6));
    const Vec3d expected = 1.0 / (1.0 - mean_reflectance);
    const auto faces = [&](bool below, bool outside) {
        return means_of(*solution, [&](const Node& node) {
            return node.kind == NodeKind::kElement && node.back == outside && (node.center.z < 0) == below;
        });
    };
    // What clusters receive is exact where their faces look one way. Here they are bowls, whose rims see each other.
    for (const bool below : {false, true}) {
        const Vec3d inside = faces(below, false).irradiance, outside = faces(below, true).irradiance;
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_NEAR(inside[channel] / expected[channel], 1, 0.16) << "channel " << channel;
            EXPECT_LT(outside[channel] / expected[channel], 0.03) << "channel " << channel;
        }
    }
}

}  // namespace
}  // namespace gg::test
