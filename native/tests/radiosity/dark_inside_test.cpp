// No light comes through thin walls, under floors or into closed cupboards.
#include <gtest/gtest.h>

#include <algorithm>

#include "radiosity/solution.h"
#include "support/law_scenes.h"
#include "support/meshes.h"

namespace gg::test {
namespace {

constexpr float kThin = 0.03F;
constexpr float kOutside = 20;  // W/m2, about, on the roof

// A hut of six closed boards that reach into one another, on a large field under sun and sky.
class Hut {
  public:
    explicit Hut(bool one_mesh) {
        builder_.description.world = Rgb(2.0F);
        builder_.sun({0.4F, 0.3F, -1}, Rgb(16));
        grey_ = builder_.material(Rgb(0.6F));
        builder_.quad({-9, -9, -0.5F}, {9, -9, -0.5F}, {9, 9, -0.5F}, {-9, 9, -0.5F}, grey_, "field");
        const Vec3 size(4.0F, 3.0F, 2.4F);
        MeshDescription all;
        for (int axis = 0; axis < 3; ++axis) {
            for (const bool far : {false, true}) {
                Vec3 lower(-0.5F * kThin), upper = size + Vec3(0.5F * kThin);
                (far ? lower : upper)[axis] = far ? size[axis] : 0.0F;
                (far ? upper : lower)[axis] += far ? 0.5F * kThin : -0.5F * kThin;
                const MeshDescription board = split(make_box(lower, upper));
                if (one_mesh) {
                    all = all.positions.empty() ? board : join(all, board);
                } else {
                    builder_.add_mesh(board, grey_);
                }
            }
        }
        if (one_mesh) {
            builder_.add_mesh(split(all), grey_);
        }
        first_inside_ = builder_.description.instances.size();
        builder_.solid({1, 1, 0.1F}, {1.6F, 1.8F, 0.9F}, grey_, "chest");
        builder_.sphere({2.6F, 1.5F, 1.2F}, 0.4F, 24, grey_, false, "ball");
    }

    // The largest irradiance anywhere inside.
    float brightest_inside() {
        Prepared prepared(builder_.description);
        const auto solution = prepared.solve();
        float most = 0;
        const Vec3 middle(2.0F, 1.5F, 1.2F);
        for (std::uint32_t instance = 1; instance < prepared.scene.instances.size(); ++instance) {
            const Mesh& mesh = prepared.scene.meshes[prepared.scene.instances[instance].mesh];
            for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
                const auto corner = world_triangle(prepared.scene, instance, triangle);
                const Vec3 normal = world_area_vector(prepared.scene, instance, triangle);
                const bool inside = instance >= first_inside_ || dot(middle - corner[0], normal) > 0;
                for (const Vec2 place : {Vec2(0.3F, 0.3F), Vec2(0.05F, 0.9F), Vec2(0.9F, 0.05F), Vec2(0.05F, 0.05F)}) {
                    if (inside) {
                        const Rgb e = interpolated_irradiance(*solution, instance, triangle, false, place);
                        most = std::max(most, luminance(e));
                    }
                }
            }
        }
        return most;
    }

  private:
    SceneBuilder builder_;
    std::uint32_t grey_ = 0;
    std::size_t first_inside_ = 0;
};

TEST(DarkInside, hut_of_separate_boards) {
    EXPECT_LT(Hut(false).brightest_inside(), 1e-3F * kOutside);
}

TEST(DarkInside, hut_of_one_mesh) {
    EXPECT_LT(Hut(true).brightest_inside(), 1e-3F * kOutside);
}

}  // namespace
}  // namespace gg::test
