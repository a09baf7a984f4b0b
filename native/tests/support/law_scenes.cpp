#include "support/law_scenes.h"

#include "support/clouds.h"

namespace gg::test {

namespace {

constexpr Box kBelowWindow{{0.3F, 2.0F, 0.1F}, {1.3F, 2.8F, 1.2F}};
constexpr Box kCorner{{3.2F, 0.2F, 1.4F}, {3.8F, 0.8F, 2.0F}};

}  // namespace

void add_furniture(SceneBuilder& builder, std::uint32_t material) {
    builder.solid({1, 1, 0.2F}, {1.7F, 1.8F, 0.9F}, material);
    builder.sphere({2.8F, 1.4F, 0.8F}, 0.5F, 24, material, false);
}

SceneDescription furnace(float reflectance, bool furnished) {
    SceneBuilder builder;
    const std::uint32_t m = builder.material(Rgb(reflectance), Rgb(1 / kPi));
    builder.box(Vec3(0.0F), kRoomSize, {m, m, m, m, m, m}, true);
    if (furnished) {
        add_furniture(builder, m);
    }
    return builder.description;
}

SceneDescription lamp_room(float reflectance) {
    SceneBuilder builder;
    const std::uint32_t m = builder.material(Rgb(reflectance));
    builder.box(Vec3(0.0F), kRoomSize, {m, m, m, m, m, m}, true);
    add_furniture(builder, m);
    builder.area_light({2, 1.5F, 2.4F}, {0, 0, -1}, 1, Rgb(100));
    return builder.description;
}

SceneDescription mixed_scene() {
    SceneBuilder builder;
    const std::uint32_t grey = builder.material(Rgb(0.6F));
    const std::uint32_t red = builder.material(Rgb(0.7F, 0.2F, 0.1F));
    const std::uint32_t green = builder.material(Rgb(0.2F, 0.5F, 0.1F));
    const std::uint32_t glowing = builder.material(Rgb(0.5F), Rgb(0.5F, 0.8F, 1));
    const std::uint32_t floor = builder.checkerboard(0.1F, 0.8F);
    builder.box(Vec3(0.0F), kRoomSize, {red, glowing, grey, grey, floor, grey}, true);
    builder.description.instances.erase(builder.description.instances.begin() + 3);
    add_furniture(builder, grey);
    builder.add_mesh(triangle_cloud(kBelowWindow, 1500, 0.08F, 1), green);
    builder.add_mesh(cube_cloud(kCorner, 60, 0.05F, 2), red);
    builder.description.world = Rgb(1, 1.5F, 2);
    builder.sun({0.3F, -1, -0.8F}, Rgb(30));
    builder.area_light({2, 1.5F, 2.4F}, {0, 0, -1}, 0.5F, Rgb(100));
    builder.point_light({3.5F, 2.5F, 1.5F}, Rgb(20));
    return builder.description;
}

double lamp_power(const Scene& scene) {
    double power = 0;
    for (const Lamp& lamp : scene.lamps) {
        power += kPi * luminance(lamp.radiance) * 4 * length(cross(lamp.half_x, lamp.half_y));
    }
    return power;
}

}  // namespace gg::test
