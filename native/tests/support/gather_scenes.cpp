#include "support/gather_scenes.h"

#include <cmath>

#include "support/clouds.h"
#include "support/grid_picture.h"
#include "support/law_scenes.h"

namespace gg::test {

namespace {

SceneBuilder window_room() {
    SceneBuilder builder;
    const std::uint32_t white = builder.material(Rgb(0.75F)), red = builder.material(Rgb(0.6F, 0.2F, 0.1F)),
                        brown = builder.material(Rgb(0.4F, 0.3F, 0.2F));
    builder.box(Vec3(0.0F), kRoomSize, {red, white, white, white, brown, white}, true);
    builder.description.instances.erase(builder.description.instances.begin() + 3);
    const float left = 1.4F, right = 2.6F, sill = 0.9F, lintel = 1.9F;
    const auto wall = [&](float x0, float x1, float z0, float z1) {
        builder.quad({x0, 3, z0}, {x1, 3, z0}, {x1, 3, z1}, {x0, 3, z1}, white, "window wall");
    };
    wall(0, left, 0, 2.5F);
    wall(right, 4, 0, 2.5F);
    wall(left, right, 0, sill);
    wall(left, right, lintel, 2.5F);
    add_furniture(builder, white);
    builder.description.world = Rgb(1, 1.3F, 1.8F);
    builder.sun({-0.3F, -1, -0.8F}, Rgb(20));
    return builder;
}

const CameraDescription kFromCorner = camera_at({3.7F, 0.2F, 1.5F}, {1.2F, 2.2F, 0.7F});

}  // namespace

ViewedScene viewed_lamp_room() {
    return {lamp_room(0.5F), kFromCorner};
}

ViewedScene viewed_mixed_scene() {
    return {mixed_scene(), camera_at({3.7F, 0.9F, 1.3F}, {0.8F, 2.3F, 0.6F})};
}

ViewedScene viewed_window_room() {
    return {window_room().description, kFromCorner};
}

ViewedScene viewed_stage() {
    SceneBuilder builder;
    const std::uint32_t grey = builder.material(Rgb(0.5F)), warm = builder.material(Rgb(0), Rgb(3, 2, 1)),
                        cold = builder.material(Rgb(0), Rgb(1, 2, 3));
    builder.quad({-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}, grey, "floor");
    builder.quad({-1, 2.2F, 1}, {-1, 2.6F, 2}, {1, 2.6F, 2}, {1, 2.2F, 1}, warm, "panel");
    builder.quad({-2.2F, -1, 1}, {-2.6F, -1, 2}, {-2.6F, 1, 2}, {-2.2F, 1, 1}, cold, "panel");
    builder.area_light({0.5F, 0.5F, 2.4F}, {0, 0, -1}, 0.6F, Rgb(60));
    builder.point_light({-1, 1, 1.5F}, Rgb(20));
    return {builder.description, camera_at({2.5F, -2.5F, 2}, {0, 0.3F, 0})};
}

ViewedScene viewed_furnished_room() {
    SceneBuilder builder = window_room();
    builder.area_light({2, 1.5F, 2.4F}, {0, 0, -1}, 0.5F, Rgb(100));
    const std::uint32_t green = builder.material(Rgb(0.3F, 0.6F, 0.3F));
    for (int i = 0; i < 12; ++i) {
        const auto x = static_cast<float>(i % 4), y = static_cast<float>(i / 4);
        const float radius = 0.1F + 0.03F * static_cast<float>(i % 5);
        builder.sphere({0.4F + x, 0.5F + 0.9F * y, i % 2 == 0 ? radius : 1.2F}, radius, 84, green, false);
    }
    return {builder.description, kFromCorner};
}

ViewedScene viewed_jungle(std::uint32_t count) {
    SceneBuilder builder = window_room();
    const std::uint32_t green = builder.material(Rgb(0.15F, 0.4F, 0.1F));
    const float edge = 5 / std::sqrt(static_cast<float>(count));
    builder.add_mesh(triangle_cloud({{0.3F, 1.9F, 0.3F}, {1.2F, 2.8F, 1.8F}}, count, edge, 1), green);
    builder.add_mesh(triangle_cloud({{2.9F, 2.1F, 0.2F}, {3.7F, 2.8F, 1.3F}}, count, edge, 2), green);
    builder.add_mesh(triangle_cloud({{0.2F, 0.3F, 0.1F}, {1, 0.9F, 1}}, count, edge, 3), green);
    return {builder.description, kFromCorner};
}

}  // namespace gg::test
