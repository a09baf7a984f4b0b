#include "gather/light_jumps.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <gtest/gtest.h>

namespace gg::test {
namespace {

// Ten metres above the origin, looking down: pixels are 1 cm wide there.
PixelCamera camera_above() {
    CameraDescription camera;
    camera.to_world.translation = {0, 0, 10};
    const float window[4] = {-0.05F, 0.05F, -0.05F, 0.05F};
    std::copy(std::begin(window), std::end(window), camera.window);
    return {camera, 100, 100};
}

// Two tiles of one row each; every pixel has one fragment of a grey surface.
struct Row {
    std::vector<TileFragments> tiles = std::vector<TileFragments>(2);
    std::vector<TileLight> light = std::vector<TileLight>(2);

    explicit Row(const std::vector<float>& irradiance) {
        const auto half = static_cast<std::uint32_t>(irradiance.size() / 2);
        for (std::uint32_t t = 0; t < 2; ++t) {
            tiles[t].tile = {t * half, 0, half, 1};
            for (std::uint32_t p = 0; p < half; ++p) {
                Fragment fragment;
                fragment.hit.instance = 3;
                fragment.normal = {0, 0, 1};
                fragment.share = 1;
                fragment.albedo = Rgb(0.5F);
                tiles[t].fragments.push_back(fragment);
                tiles[t].pixels.push_back({p + 1, 16, Rgb(0.0F), 1, 1});
                light[t].push_back(Rgb(irradiance[t * half + p]));
            }
        }
    }

    [[nodiscard]] std::vector<std::uint32_t> found() const {
        const PixelMap map(tiles);
        std::vector<std::uint32_t> places;
        for (std::size_t t = 0; t < 2; ++t) {
            for (const JumpingFragment& jump : jumps_in(map, t, light, {}, camera_above())) {
                EXPECT_EQ(jump.fragment, 0U);
                places.push_back(tiles[t].tile.x + jump.pixel);
            }
        }
        return places;
    }
};

TEST(LightJumps, a_step_is_found_on_both_sides_and_across_tiles) {
    EXPECT_EQ(Row({1, 1, 2, 2, 2, 2}).found(), (std::vector<std::uint32_t>{1, 2}));
    EXPECT_EQ(Row({1, 1, 1, 2, 2, 2}).found(), (std::vector<std::uint32_t>{2, 3}));
}

TEST(LightJumps, a_gentle_slope_is_none) {
    EXPECT_TRUE(Row({1, 1.05F, 1.1F, 1.15F, 1.2F, 1.25F}).found().empty());
}

TEST(LightJumps, other_surfaces_do_not_count) {
    Row row({1, 1, 1, 2, 2, 2});
    for (Fragment& fragment : row.tiles[1].fragments) {
        fragment.hit.instance = 4;
    }
    EXPECT_TRUE(row.found().empty());
    Row turned({1, 1, 1, 2, 2, 2});
    for (Fragment& fragment : turned.tiles[1].fragments) {
        fragment.normal = {1, 0, 0};
    }
    EXPECT_TRUE(turned.found().empty());
}

// Leaves of a plant, one behind the other; and neighbours in the plane, which do count.
TEST(LightJumps, what_lies_behind_the_surface_does_not_count) {
    Row row({1, 1, 1, 2, 2, 2});
    for (std::uint32_t t = 0; t < 2; ++t) {
        for (std::uint32_t p = 0; p < 3; ++p) {
            row.tiles[t].fragments[p].position = {static_cast<float>(3 * t + p), 0, 0};
        }
    }
    EXPECT_EQ(row.found(), (std::vector<std::uint32_t>{2, 3}));
    for (Fragment& fragment : row.tiles[1].fragments) {
        fragment.position.z = -2;
    }
    EXPECT_TRUE(row.found().empty());
}

// From light 1 to 3, either reflected by a half: over the pixel's own light.
TEST(LightJumps, a_step_is_told_as_a_share_of_the_pixels_light) {
    Row row({1, 1, 1, 3, 3, 3});
    row.tiles[0].pixels[2].emitted = Rgb(0.5F / kPi);
    const PixelMap map(row.tiles);
    const auto dark = jumps_in(map, 0, row.light, {}, camera_above()),
               bright = jumps_in(map, 1, row.light, {}, camera_above());
    ASSERT_EQ(dark.size(), 1U);
    ASSERT_EQ(bright.size(), 1U);
    EXPECT_NEAR(dark[0].step, 1, 1e-5F);  // 1 over 0.5 and what shines by itself, 0.5
    EXPECT_NEAR(bright[0].step, 2 / 3.0F, 1e-5F);
}

// A fragment that is a fifth of its pixel: as the picture shows it.
TEST(LightJumps, a_step_counts_as_far_as_the_fragment_is_seen) {
    Row row({1, 1, 1, 3, 3, 3});
    Fragment& small = row.tiles[0].fragments[2];
    small.albedo = Rgb(0.1F);
    row.tiles[0].pixels[2].emitted = Rgb(0.4F / kPi);
    const auto found = jumps_in(PixelMap(row.tiles), 0, row.light, {}, camera_above());
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].step, 0.2F / 0.5F, 1e-5F);
}

// A metre wide, stands on the floor and shines towards +x: there the floor has light from its very edge on.
Lamp standing_lamp() {
    Lamp lamp;
    lamp.shape = LampShape::kRectangle;
    lamp.position = {0, 0, 0.5F};
    lamp.direction = {1, 0, 0};
    lamp.half_x = {0, 0.5F, 0};
    lamp.half_y = {0, 0, 0.5F};
    lamp.radiance = Rgb(2);
    return lamp;
}

TEST(LightJumps, a_lamp_that_touches_the_surface_within_a_pixel_is_a_step) {
    Lamp lamp = standing_lamp();
    Fragment floor;
    floor.normal = {0, 0, 1};
    floor.hit.distance = 10;
    const auto step_near = [&](Vec3 position) {
        floor.position = position;
        return luminance(step_at(lamp, floor, pixel_reach(floor, camera_above())));
    };
    EXPECT_NEAR(step_near({0.008F, 0, 0}), kPi, 1e-5F);  // half of all around, of radiance 2
    EXPECT_NEAR(step_near({-0.008F, 0.505F, -0.005F}), kPi, 1e-5F);
    EXPECT_EQ(step_near({0.012F, 0, 0}), 0);
    EXPECT_EQ(step_near({0, 0.52F, 0}), 0);
    EXPECT_EQ(step_near({0, 0, -0.02F}), 0);
    lamp.shape = LampShape::kSphere;
    EXPECT_EQ(step_near({0, 0, 0}), 0);
    lamp.shape = LampShape::kEllipse;
    floor.normal = {1, 0, 0};  // a wall that the lamp is set into
    EXPECT_EQ(step_near({0, 0, 0}), 0);
}

// Seen at a slant, a pixel shows more of the surface.
TEST(LightJumps, a_slanted_pixel_reaches_farther) {
    const Lamp lamp = standing_lamp();
    Fragment wall;
    wall.position = {0.03F, 0, 0};
    wall.normal = {0, std::sqrt(0.9375F), 0.25F};
    wall.hit.distance = 10;
    EXPECT_GT(luminance(step_at(lamp, wall, pixel_reach(wall, camera_above()))), 0);
    wall.position.x = 0.05F;
    EXPECT_EQ(luminance(step_at(lamp, wall, pixel_reach(wall, camera_above()))), 0);
}

TEST(LightJumps, a_fragment_at_a_lamps_edge_is_found_though_no_pixel_beside_it_differs) {
    const Row row({1, 1, 1, 1});
    const Lamp lamp = standing_lamp();
    const auto found = jumps_in(PixelMap(row.tiles), 0, row.light, std::span(&lamp, 1), camera_above());
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NEAR(found[0].step, kPi, 1e-5F);  // reflected by a half, over 0.5
    EXPECT_TRUE(found[0].at_lamp);
}

// What shines by itself outshines the step.
TEST(LightJumps, only_what_the_picture_shows_counts) {
    Row row({1, 1, 1, 2, 2, 2});
    row.tiles[0].pixels[2].emitted = Rgb(20);
    row.tiles[1].pixels[0].emitted = Rgb(20);
    EXPECT_TRUE(row.found().empty());
}

}  // namespace
}  // namespace gg::test
