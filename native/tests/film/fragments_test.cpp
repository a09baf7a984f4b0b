#include "film/fragments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "core/control.h"
#include "core/messages.h"
#include "gridgather.h"
#include "material/surface_color.h"

namespace gg {
namespace {

constexpr std::uint32_t kSize = 16;

// A wall 1 m before the camera that covers what lies right of the middle; behind it a bright sky.
class FragmentsTest : public ::testing::Test {
  protected:
    FragmentsTest() {
        Mesh mesh;
        mesh.positions = {{0.01F, -2, -1}, {2, -2, -1}, {2, 2, -1}, {0.01F, 2, -1}};
        mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
        scene_.meshes = {mesh};
        scene_.instances.resize(1);
        scene_.material_lists = {{0}};
        scene_.materials.resize(1);
        scene_.materials[0].reflectance.factor = {0.5F, 0.25F, 0.75F};
        scene_.world = {2, 3, 4};
        const float window[4] = {-0.5F, 0.5F, -0.5F, 0.5F};
        std::copy(std::begin(window), std::end(window), camera_.window);
    }

    TileFragments trace() { return trace_tile(view(), {0, 0, kSize, kSize}); }
    View view() {
        return {scene_,
                *tracer(),
                *colors(),
                PixelCamera(camera_, kSize, kSize),
                PixelFilter(FilterType::kBlackmanHarris, 1.5F),
                {{0, 0, kSize, kSize}, 16, 1, false}};
    }

    Scene scene_;

  private:
    const RayTracer* tracer() {
        if (!tracer_) {
            tracer_ = std::make_unique<RayTracer>(scene_, control_);
        }
        return tracer_.get();
    }
    const SurfaceColors* colors() {
        if (!colors_) {
            colors_ = std::make_unique<SurfaceColors>(scene_, textures_, messages_);
        }
        return colors_.get();
    }

    Control control_;
    Messages messages_;
    TextureSet textures_;
    CameraDescription camera_;
    std::unique_ptr<RayTracer> tracer_;
    std::unique_ptr<SurfaceColors> colors_;
};

TEST_F(FragmentsTest, the_border_of_what_shines_has_more_samples) {
    const TileFragments tile = trace();
    ASSERT_EQ(tile.pixels.size(), kSize * kSize);
    for (std::uint32_t x = 0; x < kSize; ++x) {
        const std::uint32_t samples = tile.pixels[8 * kSize + x].samples;
        const bool border = x == kSize / 2 - 1 || x == kSize / 2;
        const bool far = x + 4 < kSize / 2 || x > kSize / 2 + 3;  // the filter reaches into them
        EXPECT_TRUE(border ? samples == 128 : (!far || samples == 16)) << x << ' ' << samples;
    }
    // The wall covers what lies beyond 0.01 of the middle: 0.16 of a pixel.
    float covered = 0;
    for (const Fragment& fragment : tile.fragments) {
        covered += fragment.share;
    }
    EXPECT_NEAR(covered / kSize, kSize / 2 - 0.16F, 0.02F);
}

// So has that of what is much lighter than what lies beside it, and the pixels beside: few samples of theirs may miss
// it.
TEST_F(FragmentsTest, the_border_of_what_is_light_has_more_samples) {
    scene_.world = Rgb(0.0F);
    scene_.instances.push_back(scene_.instances.front());
    scene_.instances.back().to_world.translation = {-2.01F, 0, 0};
    const auto samples_beside = [&](std::uint32_t steps, float light) {
        const IrradianceAt expected = [&](const Hit& hit, bool) { return Rgb(hit.instance == 1 ? light : 1.0F); };
        const TileFragments found = trace_tile(view(), {0, 0, kSize, kSize}, &expected);
        return found.pixels[8 * kSize + kSize / 2 + steps].samples;
    };
    EXPECT_EQ(trace().pixels[8 * kSize + kSize / 2].samples, 64U);
    EXPECT_EQ(samples_beside(0, 2), 64U);
    EXPECT_EQ(samples_beside(0, 4), 128U);
    EXPECT_EQ(samples_beside(0, 0.2F), 128U);
    EXPECT_EQ(samples_beside(1, 2), 16U);
    EXPECT_EQ(samples_beside(1, 4), 128U);
    EXPECT_EQ(samples_beside(2, 4), 16U);
}

TEST_F(FragmentsTest, parts_of_a_fragment_are_all_of_it) {
    const TileFragments tile = trace();
    std::size_t most = 0;
    for (std::uint32_t p = 0; p < tile.pixels.size(); ++p) {
        const auto parts = divide_pixel(view(), tile, p, 2);
        const std::uint32_t first = tile.begin_of(p);
        std::vector<float> share(tile.pixels[p].end - first), albedo(share), count(share);
        for (const FragmentPart& part : parts) {
            ASSERT_LT(part.fragment, share.size());
            share[part.fragment] += part.at.share;
            albedo[part.fragment] += part.at.albedo.y;
            count[part.fragment] += 1;
            EXPECT_NEAR(part.at.position.z, -1, 1e-5F);
        }
        for (std::size_t k = 0; k < share.size(); ++k) {
            EXPECT_NEAR(share[k], tile.fragments[first + k].share, 1e-5F);
            EXPECT_NEAR(albedo[k], tile.fragments[first + k].albedo.y, 1e-5F);
            EXPECT_GE(count[k], 1);
            EXPECT_LE(count[k], 4);
        }
        most = std::max(most, parts.size());
    }
    EXPECT_EQ(most, 4U);
}

// Sixteen samples, a part each.
TEST_F(FragmentsTest, parts_are_divided_down_to_samples) {
    const TileFragments tile = trace();
    const std::size_t pixel = 8 * kSize + 12;
    ASSERT_EQ(tile.pixels[pixel].samples, 16U);
    EXPECT_EQ(divide_pixel(view(), tile, pixel, 4).size(), 16U);
    EXPECT_EQ(divide_pixel(view(), tile, pixel, 6).size(), 16U);
}

// The four parts of a pixel lie in its four quarters.
TEST_F(FragmentsTest, parts_lie_apart) {
    const TileFragments tile = trace();
    const auto parts = divide_pixel(view(), tile, 8 * kSize + 12, 2);
    ASSERT_EQ(parts.size(), 4U);
    const float pixel = 1.0F / kSize;
    for (std::size_t a = 0; a < 4; ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            EXPECT_GT(length(parts[a].at.position - parts[b].at.position), 0.2F * pixel);
        }
    }
}

}  // namespace
}  // namespace gg
