// What a render gives back through the interface.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <thread>

#include "scenes.h"

namespace gg::test {
namespace {

class RenderTest : public ::testing::Test {
  protected:
    void render(Render& result) {
        ASSERT_EQ(gg_render_start(scene_.handle, &camera_, &settings_, &result.handle), GG_OK);
        ASSERT_EQ(gg_render_wait(result.handle, 120), GG_OK);
        gg_progress progress{};
        ASSERT_EQ(gg_render_poll(result.handle, &progress), GG_OK);
        ASSERT_EQ(progress.finished, 1);
        ASSERT_EQ(progress.status, GG_OK) << gg_render_error(result.handle);
    }
    std::vector<float> read(const Render& result) {
        std::vector<float> rgba(std::size_t{4} * settings_.width * settings_.height);
        const gg_tile all{0, 0, settings_.width, settings_.height};
        EXPECT_EQ(gg_render_read(result.handle, "Combined", &all, rgba.data()), GG_OK);
        return rgba;
    }

    Ground ground_{8, 0};
    Scene scene_;
    gg_camera camera_ = camera_above();
    gg_settings settings_ = small_settings();
};

// Irradiance of a parallel square of side 1 at distance 2 below its centre, radiance P / 4 [HOWELL, C-11, four
// corners].
double expected_radiance(double power, double reflectance) {
    const double x = 0.25;  // half side over distance
    const double s = std::sqrt(1 + x * x);
    const double form_factor = 4 / (2 * M_PI) * 2 * (x / s * std::atan(x / s));
    return reflectance * form_factor * power / 4;
}

TEST_F(RenderTest, a_quad_lit_by_one_area_lamp_is_as_bright_as_its_form_factor) {
    ASSERT_TRUE(fill_scene(scene_.handle, ground_.mesh, 100));
    settings_.quality = 0.02F;
    Render result;
    render(result);
    const std::vector<float> rgba = read(result);
    const float* centre = &rgba[4 * (20 * 48 + 24)];
    EXPECT_NEAR(centre[0], expected_radiance(100, 0.5), 0.05 * expected_radiance(100, 0.5));
    EXPECT_FLOAT_EQ(centre[3], 1);
    const float* corner = &rgba[0];
    EXPECT_EQ(corner[0], 0);  // the black world beyond the ground's edge
}

TEST_F(RenderTest, passes_that_are_asked_for_are_kept) {
    ASSERT_TRUE(fill_scene(scene_.handle, ground_.mesh, 100));
    settings_.method = GG_METHOD_GATHER;
    settings_.passes = GG_PASS_RESAMPLED_SENDERS | GG_PASS_CELL_LINES;
    Render result;
    render(result);
    const gg_tile all{0, 0, settings_.width, settings_.height};
    std::vector<float> senders(std::size_t{settings_.width} * settings_.height, -1.0F), lines = senders;
    EXPECT_EQ(gg_render_read(result.handle, "Resampled Senders", &all, senders.data()), GG_OK);
    EXPECT_EQ(gg_render_read(result.handle, "Cell Lines", &all, lines.data()), GG_OK);
    EXPECT_EQ(gg_render_read(result.handle, "Form Factor Samples", &all, lines.data()), GG_INVALID_ARGUMENT);
    EXPECT_EQ(senders[20 * 48 + 24], 1);  // one lamp
    EXPECT_EQ(senders[0], 0);             // beyond the ground
    EXPECT_EQ(std::count(lines.begin(), lines.end(), 0) + std::count(lines.begin(), lines.end(), 1), 48 * 40);
    EXPECT_GT(std::count(lines.begin(), lines.end(), 1), 48);
}

TEST_F(RenderTest, tiles_arrive_until_all_have) {
    ASSERT_TRUE(fill_scene(scene_.handle, ground_.mesh));
    Render result;
    render(result);
    gg_tile tile{};
    std::int32_t found = 1;
    std::uint32_t pixels = 0;
    int tiles = 0;
    while (found) {
        ASSERT_EQ(gg_render_next_tile(result.handle, &tile, &found), GG_OK);
        if (found) {
            pixels += tile.width * tile.height;
            ++tiles;
        }
    }
    EXPECT_EQ(pixels, 48U * 40U);
    gg_progress progress{};
    ASSERT_EQ(gg_render_poll(result.handle, &progress), GG_OK);
    EXPECT_EQ(progress.tiles, static_cast<std::uint32_t>(tiles));
    EXPECT_EQ(progress.finished_tiles, progress.tiles);
    EXPECT_EQ(progress.fraction, 1);
    EXPECT_GT(progress.memory, 48U * 40U * 16U);
    EXPECT_GE(progress.peak_memory, progress.memory);
    EXPECT_STREQ(gg_render_error(result.handle), "");
}

TEST_F(RenderTest, a_crop_reads_as_the_full_pictures_part) {
    ASSERT_TRUE(fill_scene(scene_.handle, ground_.mesh));
    Render full;
    render(full);
    const std::vector<float> expected = read(full);
    const std::uint32_t crop[4] = {10, 5, 20, 30};
    std::copy(std::begin(crop), std::end(crop), settings_.crop);
    Render part;
    render(part);
    std::vector<float> rgba(20 * 30 * 4);
    const gg_tile all{0, 0, 20, 30};
    ASSERT_EQ(gg_render_read(part.handle, "Combined", &all, rgba.data()), GG_OK);
    for (std::size_t row = 0; row < 30; ++row) {
        EXPECT_EQ(std::memcmp(&rgba[row * 20 * 4], &expected[((5 + row) * 48 + 10) * 4], 20 * 4 * sizeof(float)), 0);
    }
}

TEST_F(RenderTest, film_transparency_and_exposure_reach_the_picture) {
    ASSERT_TRUE(fill_scene(scene_.handle, ground_.mesh));
    const float world[3] = {1, 1, 1};
    ASSERT_EQ(gg_scene_set_world(scene_.handle, world), GG_OK);
    Render opaque;
    render(opaque);
    EXPECT_FLOAT_EQ(read(opaque)[0], 1);
    EXPECT_FLOAT_EQ(read(opaque)[3], 1);
    settings_.film_transparent = 1;
    settings_.exposure = 2;
    Render clear;
    render(clear);
    EXPECT_FLOAT_EQ(read(clear)[0], 0);
    EXPECT_FLOAT_EQ(read(clear)[3], 0);
    EXPECT_FLOAT_EQ(read(clear)[4 * (20 * 48 + 24)], 2 * read(opaque)[4 * (20 * 48 + 24)]);
}

TEST_F(RenderTest, a_cameras_scale_means_nothing) {
    ASSERT_TRUE(fill_scene(scene_.handle, ground_.mesh));
    Render plain;
    render(plain);
    for (const int index : {0, 4, 8}) {
        camera_.matrix[index] *= 3;
        camera_.matrix[index + 1] *= 3;
        camera_.matrix[index + 2] *= 3;
    }
    Render scaled;
    render(scaled);
    EXPECT_EQ(read(plain), read(scaled));
}

TEST_F(RenderTest, statistics_are_json_and_show_that_lighting_is_reused) {
    ASSERT_TRUE(fill_scene(scene_.handle, ground_.mesh));
    const std::string number = "-?[0-9]+(\\.[0-9]+)?([eE][-+]?[0-9]+)?";
    const std::string table = "\\{(\"[^\"\\\\]+\": " + number + "(, \"[^\"\\\\]+\": " + number + ")*)?\\}";
    const std::string shape = "\\{\"stages\": " + table + ", \"counts\": " + table + ", \"memory\": " + table + "\\}";
    Render first;
    render(first);
    const char* json = nullptr;
    ASSERT_EQ(gg_render_statistics(first.handle, &json), GG_OK);
    EXPECT_THAT(json, ::testing::MatchesRegex(shape));
    for (const char* key : {"\"build scene\"", "\"textures\"", "\"trace: build\"", "\"picture\"", "\"triangles\": 128",
                            "\"instances\": 1", "\"lamps\": 1", "\"dropped samples\": 0"}) {
        EXPECT_NE(std::strstr(json, key), nullptr) << key << json;
    }
    Render second;
    render(second);
    ASSERT_EQ(gg_render_statistics(second.handle, &json), GG_OK);
    EXPECT_THAT(json, ::testing::MatchesRegex(shape));
    EXPECT_EQ(std::strstr(json, "\"build scene\""), nullptr) << json;
    EXPECT_EQ(std::strstr(json, "\"refine\""), nullptr) << json;
    EXPECT_NE(std::strstr(json, "\"triangles\": 128"), nullptr) << json;
    EXPECT_EQ(read(first), read(second));
}

TEST_F(RenderTest, statistics_of_an_unfinished_render_are_refused) {
    const Ground large(200, 0.3F);
    ASSERT_TRUE(fill_scene(scene_.handle, large.mesh));
    settings_.quality = 0.001F;
    Render result;
    ASSERT_EQ(gg_render_start(scene_.handle, &camera_, &settings_, &result.handle), GG_OK);
    const char* json = nullptr;
    EXPECT_EQ(gg_render_statistics(result.handle, &json), GG_WRONG_STATE);
    EXPECT_STREQ(gg_render_error(result.handle), "");
}

TEST_F(RenderTest, messages_of_the_caller_and_of_the_scene_are_read_back) {
    const float broken[9] = {0, 0, 0, 1, 0, 0, 0, 1, std::numeric_limits<float>::quiet_NaN()};
    const std::uint32_t triangle[3] = {0, 1, 2};
    gg_mesh mesh{};
    mesh.name = "broken";
    mesh.vertex_count = 3;
    mesh.positions = broken;
    mesh.triangle_count = 1;
    mesh.triangle_vertices = triangle;
    ASSERT_TRUE(fill_scene(scene_.handle, mesh));
    const std::string long_name = std::string(126, 'x') + "\xC3\xA4\xC3\xA4";  // a cut would divide the first umlaut
    ASSERT_EQ(gg_scene_add_message(scene_.handle, long_name.c_str(), "no node"), GG_OK);
    ASSERT_EQ(gg_scene_add_message(scene_.handle, long_name.c_str(), "no node"), GG_OK);
    for (int time = 0; time < 2; ++time) {  // the second render takes the scene from the cache
        Render result;
        render(result);
        gg_message message{};
        std::int32_t found = 0;
        ASSERT_EQ(gg_render_message(result.handle, 0, &message, &found), GG_OK);
        ASSERT_EQ(found, 1);
        EXPECT_EQ(message.object, std::string(126, 'x'));
        EXPECT_STREQ(message.text, "no node");
        EXPECT_EQ(message.count, 2U);
        bool about_mesh = false;
        for (std::uint32_t index = 1; found; ++index) {
            ASSERT_EQ(gg_render_message(result.handle, index, &message, &found), GG_OK);
            about_mesh = about_mesh || (found && std::strcmp(message.object, "broken") == 0);
        }
        EXPECT_TRUE(about_mesh);
    }
}

TEST_F(RenderTest, an_empty_scene_shows_its_world) {
    const float world[3] = {0.25F, 0.5F, 1};
    ASSERT_EQ(gg_scene_set_world(scene_.handle, world), GG_OK);
    Render result;
    render(result);
    const std::vector<float> rgba = read(result);
    EXPECT_FLOAT_EQ(rgba[0], 0.25F);
    EXPECT_FLOAT_EQ(rgba[1], 0.5F);
    EXPECT_FLOAT_EQ(rgba[2], 1);
}

TEST_F(RenderTest, two_renders_of_one_scene_may_run_at_once) {
    const Ground bumpy(40, 0.3F);
    ASSERT_TRUE(fill_scene(scene_.handle, bumpy.mesh));
    Render first;
    Render second;
    ASSERT_EQ(gg_render_start(scene_.handle, &camera_, &settings_, &first.handle), GG_OK);
    ASSERT_EQ(gg_render_start(scene_.handle, &camera_, &settings_, &second.handle), GG_OK);
    ASSERT_EQ(gg_render_wait(first.handle, 120), GG_OK);
    ASSERT_EQ(gg_render_wait(second.handle, 120), GG_OK);
    EXPECT_EQ(read(first), read(second));
}

TEST(last_error, belongs_to_the_calling_thread) {
    EXPECT_NE(gg_scene_create(nullptr), GG_OK);
    const std::string here = gg_last_error();
    std::string there = "unset";
    std::thread([&] { there = gg_last_error(); }).join();
    EXPECT_NE(here, "");
    EXPECT_EQ(there, "");
}

}  // namespace
}  // namespace gg::test
