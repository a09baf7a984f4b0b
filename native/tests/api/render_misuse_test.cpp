// Every function about renders, misused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <functional>
#include <limits>

#include "scenes.h"

namespace gg::test {
namespace {

const float kNan = std::numeric_limits<float>::quiet_NaN();

class RenderMisuse : public ::testing::Test {
  protected:
    RenderMisuse() { EXPECT_TRUE(fill_scene(scene_.handle, ground_.mesh)); }

    gg_status start(const gg_camera* camera, const gg_settings& settings) {
        Render render;
        return gg_render_start(scene_.handle, camera, &settings, &render.handle);
    }
    void finish(Render& render) {
        ASSERT_EQ(gg_render_start(scene_.handle, &camera_, &settings_, &render.handle), GG_OK);
        ASSERT_EQ(gg_render_wait(render.handle, 60), GG_OK);
    }

    Ground ground_{4, 0};
    Scene scene_;
    gg_camera camera_ = camera_above();
    gg_settings settings_ = small_settings();
};

TEST_F(RenderMisuse, start_needs_its_arguments) {
    gg_render* render = nullptr;
    EXPECT_EQ(gg_render_start(nullptr, &camera_, &settings_, &render), GG_INVALID_ARGUMENT);
    EXPECT_EQ(gg_render_start(scene_.handle, &camera_, nullptr, &render), GG_INVALID_ARGUMENT);
    EXPECT_EQ(gg_render_start(scene_.handle, &camera_, &settings_, nullptr), GG_INVALID_ARGUMENT);
    EXPECT_EQ(gg_render_start(scene_.handle, nullptr, &settings_, &render), GG_INVALID_SCENE);
    EXPECT_EQ(render, nullptr);
    const float world[3] = {1, 1, 1};
    EXPECT_EQ(gg_scene_set_world(scene_.handle, world), GG_OK);  // not frozen by failures
}

TEST_F(RenderMisuse, settings_out_of_range_are_refused) {
    const std::function<void(gg_settings&)> faults[] = {
        [](gg_settings& s) { s.method = -1; },
        [](gg_settings& s) { s.method = 3; },
        [](gg_settings& s) { s.width = 0; },
        [](gg_settings& s) { s.height = 65537; },
        [](gg_settings& s) { s.crop[2] = 10; },
        [](gg_settings& s) { s.crop[0] = 40, s.crop[2] = 9, s.crop[3] = 1; },
        [](gg_settings& s) { s.crop[1] = 40, s.crop[2] = 1, s.crop[3] = 1; },
        [](gg_settings& s) { s.crop[2] = 0xFFFFFFFF, s.crop[3] = 0xFFFFFFFF; },
        [](gg_settings& s) { s.quality = 2; },
        [](gg_settings& s) { s.quality = kNan; },
        [](gg_settings& s) { s.samples = 257; },
        [](gg_settings& s) { s.passes = 256; },
        [](gg_settings& s) { s.sites = 2; },
        [](gg_settings& s) { s.receivers = 2; },
        [](gg_settings& s) { s.depth_law = -1; },
        [](gg_settings& s) { s.cell_size = 3; },
        [](gg_settings& s) { s.threshold = 2; },
        [](gg_settings& s) { s.gather_samples = 8; },
        [](gg_settings& s) { s.filter_width = -1; },
        [](gg_settings& s) { s.filter_type = 3; },
        [](gg_settings& s) { s.exposure = -1; },
        [](gg_settings& s) { s.exposure = kNan; },
        [](gg_settings& s) { s.threads = -1; },
        [](gg_settings& s) { s.noticeable = -1; },
    };
    int index = 0;
    for (const auto& fault : faults) {
        gg_settings settings = settings_;
        fault(settings);
        EXPECT_EQ(start(&camera_, settings), GG_INVALID_ARGUMENT) << index;
        EXPECT_STRNE(gg_last_error(), "");
        ++index;
    }
}

TEST_F(RenderMisuse, displays_out_of_range_are_refused) {
    const std::function<void(gg_display&)> faults[] = {
        [](gg_display& d) { d.exposure = 65; },
        [](gg_display& d) { d.exposure = kNan; },
        [](gg_display& d) { d.gamma = -1; },
        [](gg_display& d) { d.white = -1; },
        [](gg_display& d) { d.white = kNan; },
        [](gg_display& d) { d.black = -1; },
        [](gg_display& d) { d.pixels_per_degree = 0.5F; },
    };
    int index = 0;
    for (const auto& fault : faults) {
        gg_display display{};
        fault(display);
        gg_settings settings = settings_;
        settings.display = &display;
        EXPECT_EQ(start(&camera_, settings), GG_INVALID_ARGUMENT) << index;
        ++index;
    }
}

TEST_F(RenderMisuse, curves_out_of_range_are_refused) {
    std::vector<float> values(6, 0.5F);
    const std::function<void(gg_curves&)> faults[] = {
        [](gg_curves& c) { c.values = nullptr; },  [](gg_curves& c) { c.size = 1; },
        [](gg_curves& c) { c.size = 65537; },      [](gg_curves& c) { c.range[1] = c.range[0]; },
        [](gg_curves& c) { c.range[0] = kNan; },   [](gg_curves& c) { c.slopes[5] = kNan; },
        [](gg_curves& c) { c.black[1] = kNan; },   [](gg_curves& c) { c.white[2] = kNan; },
        [&](gg_curves&) { values.back() = kNan; },  // the last one: values stay so
    };
    float pixel[3] = {0.5F, 0.5F, 0.5F};
    gg_curves curves{values.data(), 2, {0, 1}, {}, {}, {1, 1, 1}};
    gg_display display{};
    display.curves = &curves;
    EXPECT_EQ(gg_display_encode(&display, pixel, 1), GG_OK);
    int index = 0;
    for (const auto& fault : faults) {
        curves = {values.data(), 2, {0, 1}, {}, {}, {1, 1, 1}};
        fault(curves);
        EXPECT_EQ(gg_display_encode(&display, pixel, 1), GG_INVALID_ARGUMENT) << index++;
    }
}

TEST_F(RenderMisuse, encoding_needs_a_display_and_pixels) {
    gg_display display{};
    float pixels[3] = {0.5F, 0.5F, 0.5F};
    EXPECT_EQ(gg_display_encode(nullptr, pixels, 1), GG_INVALID_ARGUMENT);
    EXPECT_EQ(gg_display_encode(&display, nullptr, 1), GG_INVALID_ARGUMENT);
    EXPECT_EQ(gg_display_encode(&display, nullptr, 0), GG_OK);
    EXPECT_EQ(gg_display_encode(&display, pixels, std::uint64_t{1} << 40), GG_INVALID_ARGUMENT);
    display.config = "/nowhere/config.ocio";
    EXPECT_EQ(gg_display_encode(&display, pixels, 1), GG_INVALID_ARGUMENT);
    EXPECT_STRNE(gg_last_error(), "");
    EXPECT_EQ(pixels[0], 0.5F);  // nothing changed
    display.config = nullptr;
    EXPECT_EQ(gg_display_encode(&display, pixels, 1), GG_OK);
    EXPECT_NEAR(pixels[0], 0.73536F, 1e-4F);
}

TEST_F(RenderMisuse, captures_need_all_arguments_and_an_open_scene) {
    const std::string path = testing::TempDir() + "gg_capture_misuse";
    EXPECT_EQ(gg_scene_capture(nullptr, &camera_, &settings_, path.c_str()), GG_INVALID_ARGUMENT);
    EXPECT_EQ(gg_scene_capture(scene_.handle, &camera_, nullptr, path.c_str()), GG_INVALID_ARGUMENT);
    EXPECT_EQ(gg_scene_capture(scene_.handle, &camera_, &settings_, nullptr), GG_INVALID_ARGUMENT);
    EXPECT_EQ(gg_scene_capture(scene_.handle, nullptr, &settings_, path.c_str()), GG_INVALID_SCENE);
    EXPECT_FALSE(std::ifstream(path).good());
    EXPECT_EQ(gg_scene_capture(scene_.handle, &camera_, &settings_, "/nowhere/capture"), GG_IO_ERROR);
    EXPECT_THAT(gg_last_error(), testing::HasSubstr("/nowhere/capture"));
    EXPECT_EQ(gg_scene_capture(scene_.handle, &camera_, &settings_, path.c_str()), GG_OK);
    EXPECT_TRUE(std::ifstream(path).good());
    std::remove(path.c_str());
    Render render;
    ASSERT_EQ(gg_render_start(scene_.handle, &camera_, &settings_, &render.handle), GG_OK);
    EXPECT_EQ(gg_scene_capture(scene_.handle, &camera_, &settings_, path.c_str()), GG_WRONG_STATE);
    EXPECT_FALSE(std::ifstream(path).good());
}

TEST_F(RenderMisuse, cameras_out_of_range_are_refused) {
    const std::function<void(gg_camera&)> faults[] = {
        [](gg_camera& c) { c.type = 2; },         [](gg_camera& c) { c.matrix[3] = kNan; },
        [](gg_camera& c) { c.matrix[10] = 0; },   [](gg_camera& c) { c.window[0] = 1; },
        [](gg_camera& c) { c.window[3] = kNan; }, [](gg_camera& c) { c.clip_start = -1; },
        [](gg_camera& c) { c.clip_end = 0; },     [](gg_camera& c) { c.clip_end = kNan; },
    };
    int index = 0;
    for (const auto& fault : faults) {
        gg_camera camera = camera_;
        fault(camera);
        EXPECT_EQ(start(&camera, settings_), GG_INVALID_ARGUMENT) << index;
        ++index;
    }
}

TEST_F(RenderMisuse, what_is_no_render_is_refused) {
    std::vector<std::uint64_t> zeros(100, 0);
    gg_progress progress{};
    gg_tile tile{0, 0, 1, 1};
    gg_message message{};
    std::int32_t found = 0;
    const char* json = nullptr;
    float rgba[4];
    for (gg_render* render : {static_cast<gg_render*>(nullptr), reinterpret_cast<gg_render*>(zeros.data()),
                              reinterpret_cast<gg_render*>(scene_.handle)}) {
        EXPECT_EQ(gg_render_poll(render, &progress), GG_INVALID_ARGUMENT);
        EXPECT_EQ(gg_render_wait(render, 1), GG_INVALID_ARGUMENT);
        EXPECT_EQ(gg_render_cancel(render), GG_INVALID_ARGUMENT);
        EXPECT_STRNE(gg_render_error(render), "");
        EXPECT_EQ(gg_render_next_tile(render, &tile, &found), GG_INVALID_ARGUMENT);
        EXPECT_EQ(gg_render_read(render, "Combined", &tile, rgba), GG_INVALID_ARGUMENT);
        EXPECT_EQ(gg_render_statistics(render, &json), GG_INVALID_ARGUMENT);
        EXPECT_EQ(gg_render_message(render, 0, &message, &found), GG_INVALID_ARGUMENT);
        gg_render_destroy(render);
    }
}

TEST_F(RenderMisuse, null_places_for_results_are_refused) {
    Render render;
    finish(render);
    gg_tile tile{0, 0, 1, 1};
    gg_message message{};
    std::int32_t found = 0;
    float rgba[4];
    EXPECT_EQ(gg_render_poll(render.handle, nullptr), GG_INVALID_ARGUMENT);
    EXPECT_EQ(gg_render_wait(render.handle, kNan), GG_INVALID_ARGUMENT);
    EXPECT_EQ(gg_render_wait(render.handle, -1), GG_INVALID_ARGUMENT);
    EXPECT_EQ(gg_render_next_tile(render.handle, nullptr, &found), GG_INVALID_ARGUMENT);
    EXPECT_EQ(gg_render_next_tile(render.handle, &tile, nullptr), GG_INVALID_ARGUMENT);
    EXPECT_EQ(gg_render_read(render.handle, nullptr, &tile, rgba), GG_INVALID_ARGUMENT);
    EXPECT_EQ(gg_render_read(render.handle, "Depth", &tile, rgba), GG_INVALID_ARGUMENT);
    EXPECT_EQ(gg_render_read(render.handle, "Cell Lines", &tile, rgba), GG_INVALID_ARGUMENT);  // not asked for
    EXPECT_EQ(gg_render_read(render.handle, "Combined", nullptr, rgba), GG_INVALID_ARGUMENT);
    EXPECT_EQ(gg_render_read(render.handle, "Combined", &tile, nullptr), GG_INVALID_ARGUMENT);
    EXPECT_EQ(gg_render_statistics(render.handle, nullptr), GG_INVALID_ARGUMENT);
    EXPECT_EQ(gg_render_message(render.handle, 0, nullptr, &found), GG_INVALID_ARGUMENT);
    EXPECT_EQ(gg_render_message(render.handle, 0, &message, nullptr), GG_INVALID_ARGUMENT);
}

TEST_F(RenderMisuse, rectangles_outside_of_the_picture_are_refused) {
    Render render;
    finish(render);
    std::vector<float> rgba(48 * 40 * 4);
    for (const gg_tile& tile :
         {gg_tile{0, 0, 49, 1}, gg_tile{0, 40, 1, 1}, gg_tile{0, 0, 0, 1}, gg_tile{5, 5, 0xFFFFFFFFU, 0xFFFFFFFFU}}) {
        EXPECT_EQ(gg_render_read(render.handle, "Combined", &tile, rgba.data()), GG_INVALID_ARGUMENT);
    }
    const gg_tile all{0, 0, 48, 40};
    EXPECT_EQ(gg_render_read(render.handle, "Combined", &all, rgba.data()), GG_OK);
}

TEST_F(RenderMisuse, a_cancelled_render_still_answers) {
    Render render;
    ASSERT_EQ(gg_render_start(scene_.handle, &camera_, &settings_, &render.handle), GG_OK);
    EXPECT_EQ(gg_render_cancel(render.handle), GG_OK);
    EXPECT_EQ(gg_render_cancel(render.handle), GG_OK);
    ASSERT_EQ(gg_render_wait(render.handle, 60), GG_OK);
    gg_progress progress{};
    ASSERT_EQ(gg_render_poll(render.handle, &progress), GG_OK);
    ASSERT_EQ(progress.finished, 1);
    const char* json = nullptr;
    EXPECT_EQ(gg_render_statistics(render.handle, &json), GG_OK);
    std::vector<float> rgba(48 * 40 * 4, 5.0F);
    const gg_tile all{0, 0, 48, 40};
    EXPECT_EQ(gg_render_read(render.handle, "Combined", &all, rgba.data()), GG_OK);
    if (progress.status == GG_CANCELLED) {
        EXPECT_STRNE(gg_render_error(render.handle), "");
    }
    // And the scene can be rendered again.
    Render again;
    finish(again);
    ASSERT_EQ(gg_render_poll(again.handle, &progress), GG_OK);
    EXPECT_EQ(progress.status, GG_OK);
}

}  // namespace
}  // namespace gg::test
