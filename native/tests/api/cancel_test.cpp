// A cancel ends every stage at once.
#include <gtest/gtest.h>

#include <chrono>
#include <cstring>

#include "scenes.h"

namespace gg::test {
namespace {

class CancelTest : public ::testing::TestWithParam<const char*> {};

TEST_P(CancelTest, returns_within_a_second) {
    const std::string stage = GetParam();
    const bool to_picture = stage == "picture";
    // Small where the stages before are only in the way; elsewhere large, so that a stage lasts.
    const Ground ground(to_picture ? 8 : 500, 0.2F);
    Scene scene;
    std::vector<float> pixels(std::size_t{4} * 2048 * 2048, 0.5F);
    gg_image image{};
    image.pixels = pixels.data();
    image.width = image.height = 2048;
    std::uint32_t id = 0;
    ASSERT_EQ(gg_scene_add_image(scene.handle, &image, &id), GG_OK);
    ASSERT_TRUE(fill_scene(scene.handle, ground.mesh));
    const gg_camera camera = camera_above();
    gg_settings settings = small_settings();
    settings.quality = to_picture ? 1 : 0.001F;
    settings.width = settings.height = to_picture ? 4000 : 100;
    settings.samples = 256;
    Render render;
    ASSERT_EQ(gg_render_start(scene.handle, &camera, &settings, &render.handle), GG_OK);
    gg_progress progress{};
    while (progress.finished == 0 && progress.stage != stage) {
        ASSERT_EQ(gg_render_poll(render.handle, &progress), GG_OK);
    }
    ASSERT_EQ(progress.stage, stage);
    ASSERT_EQ(gg_render_cancel(render.handle), GG_OK);
    ASSERT_EQ(gg_render_wait(render.handle, 1), GG_OK);
    ASSERT_EQ(gg_render_poll(render.handle, &progress), GG_OK);
    EXPECT_EQ(progress.finished, 1);
    EXPECT_EQ(progress.status, GG_CANCELLED);
    EXPECT_EQ(progress.stage, stage);
}

INSTANTIATE_TEST_SUITE_P(stages, CancelTest,
                         ::testing::Values("build scene", "textures", "trace: build", "lighting", "picture"));

TEST(cancel, destroying_a_running_render_cancels_it) {
    const Ground ground(500, 0.2F);
    Scene scene;
    ASSERT_TRUE(fill_scene(scene.handle, ground.mesh));
    const gg_camera camera = camera_above();
    gg_settings settings = small_settings();
    settings.quality = 0.001F;
    gg_render* render = nullptr;
    ASSERT_EQ(gg_render_start(scene.handle, &camera, &settings, &render), GG_OK);
    ASSERT_EQ(gg_render_wait(render, 0.05F), GG_OK);
    const auto start = std::chrono::steady_clock::now();
    gg_render_destroy(render);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
}

}  // namespace
}  // namespace gg::test
