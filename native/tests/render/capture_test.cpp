#include "render/capture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/control.h"
#include "core/error.h"
#include "core/messages.h"
#include "core/statistics.h"
#include "render/prepared_scene.h"
#include "support/gather_scenes.h"

namespace gg::test {
namespace {

namespace fs = std::filesystem;

class CaptureTest : public testing::Test {
  protected:
    CaptureTest() {
        fs::create_directories(folder_);
        ImageDescription image;
        image.name = "tiles";
        image.path = "/nowhere/tiles.png";
        image.pixels = {0.1F, 0.2F, 0.3F, 1};
        image.width = image.height = 1;
        image.extension = Extension::kMirror;
        scene_.description.images.push_back(image);
        scene_.description.world = {0.1F, 0.2F, 0.3F};
        settings_.method = Method::kGather;
        settings_.camera = scene_.camera;
        settings_.width = 24;
        settings_.height = 12;
        settings_.view.crop = {2, 1, 20, 10};
        settings_.view.samples = 4;
        settings_.quality = 0.07F;
        settings_.passes.bits = 5;
        settings_.gather.cell = 30;
        settings_.masking = true;
        settings_.viewing.white = 250;
        settings_.display.emplace();
        settings_.display->look = "Punchy";
        settings_.display->curves.emplace();
        settings_.display->curves->upper = 3;
        for (auto& channel : settings_.display->curves->channels) {
            channel.values = {0, 0.7F, 1};
        }
    }
    ~CaptureTest() override { fs::remove_all(folder_); }
    CaptureTest(const CaptureTest&) = delete;
    CaptureTest& operator=(const CaptureTest&) = delete;

    [[nodiscard]] std::string file(const char* name) const { return (folder_ / name).string(); }
    static std::string bytes_of(const std::string& path) {
        std::ifstream in(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    }
    static void put(const std::string& path, std::string_view bytes) { std::ofstream(path, std::ios::binary) << bytes; }

    fs::path folder_ = fs::temp_directory_path() /
                       (std::string("gg_capture_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    ViewedScene scene_ = viewed_mixed_scene();
    RenderSettings settings_;
};

TEST_F(CaptureTest, keeps_everything) {
    write_capture(scene_.description, settings_, file("first"));
    const Capture read = read_capture(file("first"));
    write_capture(read.scene, read.settings, file("second"));
    EXPECT_EQ(bytes_of(file("first")), bytes_of(file("second")));

    const SceneDescription& scene = scene_.description;
    ASSERT_EQ(read.scene.meshes.size(), scene.meshes.size());
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        EXPECT_EQ(read.scene.meshes[i].name, scene.meshes[i].name);
        EXPECT_EQ(read.scene.meshes[i].positions, scene.meshes[i].positions);
        EXPECT_EQ(read.scene.meshes[i].triangle_vertices, scene.meshes[i].triangle_vertices);
    }
    ASSERT_EQ(read.scene.instances.size(), scene.instances.size());
    EXPECT_EQ(read.scene.instances.back().stable_id, scene.instances.back().stable_id);
    EXPECT_EQ(read.scene.instances.back().to_world.translation, scene.instances.back().to_world.translation);
    ASSERT_EQ(read.scene.lights.size(), scene.lights.size());
    EXPECT_EQ(read.scene.lights.front().power, scene.lights.front().power);
    ASSERT_EQ(read.scene.images.size(), scene.images.size());
    EXPECT_EQ(read.scene.images.back().path, "/nowhere/tiles.png");
    EXPECT_EQ(read.scene.images.back().extension, Extension::kMirror);
    EXPECT_EQ(read.scene.material_lists, scene.material_lists);
    EXPECT_EQ(read.scene.world, scene.world);
    EXPECT_EQ(read.settings.view.crop.width, 20U);
    EXPECT_EQ(read.settings.quality, 0.07F);
    EXPECT_EQ(read.settings.gather.cell, 30);
    EXPECT_TRUE(read.settings.masking);
    ASSERT_TRUE(read.settings.display && read.settings.display->curves);
    EXPECT_EQ(read.settings.display->look, "Punchy");
    EXPECT_THAT(read.settings.display->curves->channels[1].values, testing::ElementsAre(0, 0.7F, 1));
}

TEST_F(CaptureTest, renders_to_the_same_bytes) {
    settings_.display.reset();
    write_capture(scene_.description, settings_, file("capture"));
    Capture read = read_capture(file("capture"));
    const auto pixels_of = [](SceneDescription& scene, const RenderSettings& settings) {
        SceneCache cache;
        cache.description = std::move(scene);
        const Rectangle& crop = settings.view.crop;
        Film film(crop.width, crop.height, settings.passes);
        Control control;
        Messages messages;
        Statistics statistics;
        render(cache, settings, film, control, messages, statistics);
        std::vector<Rgba> pixels(std::size_t{crop.width} * crop.height);
        film.read({0, 0, crop.width, crop.height}, pixels);
        return pixels;
    };
    const std::vector<Rgba> replayed = pixels_of(read.scene, read.settings),
                            rendered = pixels_of(scene_.description, settings_);
    float sum = 0;
    for (std::size_t i = 0; i < rendered.size(); ++i) {
        EXPECT_EQ(replayed[i].color, rendered[i].color) << i;
        sum += luminance(rendered[i].color);
    }
    EXPECT_GT(sum, 0);
}

TEST_F(CaptureTest, what_is_cut_off_is_told) {
    write_capture(scene_.description, settings_, file("whole"));
    const std::string whole = bytes_of(file("whole"));
    for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 200) {
        put(file("part"), std::string_view(whole).substr(0, size));
        EXPECT_THROW((void)read_capture(file("part")), Error) << size;
    }
    put(file("more"), whole + "x");
    EXPECT_THROW((void)read_capture(file("more")), Error);
}

TEST_F(CaptureTest, counts_beyond_the_file_are_told) {
    write_capture({}, settings_, file("capture"));
    std::string bytes = bytes_of(file("capture"));
    bytes[22] = 127;  // of images: the number is 0 otherwise
    put(file("capture"), bytes);
    EXPECT_THROW((void)read_capture(file("capture")), Error);
}

TEST_F(CaptureTest, other_files_are_told) {
    put(file("other"), "gridgather capture 0\n");
    EXPECT_THROW((void)read_capture(file("other")), Error);
    EXPECT_THROW((void)read_capture(file("missing")), Error);
}

TEST_F(CaptureTest, what_cannot_be_written_leaves_nothing_behind) {
    try {
        write_capture(scene_.description, settings_, file("missing/capture"));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), GG_IO_ERROR);
        EXPECT_THAT(error.what(), testing::HasSubstr("missing/capture"));
    }
    // In the way of the new file.
    fs::create_directories(folder_ / "folder" / "inside");
    EXPECT_THROW(write_capture(scene_.description, settings_, file("folder")), Error);
    EXPECT_TRUE(fs::exists(folder_ / "folder" / "inside"));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

}  // namespace
}  // namespace gg::test
