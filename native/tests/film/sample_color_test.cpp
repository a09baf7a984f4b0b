// Textures are filtered over what a sample stands for.
#include "film/sample_color.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "core/control.h"
#include "core/messages.h"
#include "film/fragments.h"
#include "material/surface_color.h"

namespace gg {
namespace {

constexpr std::uint32_t kTexels = 64, kPixels = 16;

// A wall of 1 x 1 m with stripes of one texel, 1 m before a camera that sees just that: a pixel is four texels wide.
class SampleColorTest : public ::testing::Test {
  protected:
    SampleColorTest() {
        Mesh mesh;
        mesh.positions = {{-0.5F, -0.5F, -1}, {0.5F, -0.5F, -1}, {0.5F, 0.5F, -1}, {-0.5F, 0.5F, -1}};
        mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
        mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
        scene_.meshes = {mesh};
        scene_.instances.resize(1);
        scene_.material_lists = {{0}};
        scene_.materials.resize(1);
        scene_.materials[0].reflectance.factor = Rgb(1);
        scene_.materials[0].reflectance.image = 0;
        for (std::uint32_t i = 0; i < kTexels * kTexels; ++i) {
            const float grey = i % 2 == 0 ? 0.2F : 0.8F;
            pixels_.insert(pixels_.end(), {grey, grey, grey, 1});
        }
        ImageSource source;
        source.pixels = pixels_;
        source.width = source.height = kTexels;
        source.srgb = false;
        textures_ = TextureSet(std::span(&source, 1), control_, messages_);
        colors_ = std::make_unique<SurfaceColors>(scene_, textures_, messages_);
        const float window[4] = {-0.5F, 0.5F, -0.5F, 0.5F};
        std::copy(std::begin(window), std::end(window), camera_.window);
    }

    // How much lighter the stripes are than the dark ones' neighbours, in the middle of a dark stripe: 0.3 as they are,
    // 0 where they are averaged.
    float contrast(float share) {
        const RayTracer tracer(scene_, control_);
        const View seen = view(tracer, 16);
        const Ray ray = seen.camera.ray(5 + 0.5F * kPixels / kTexels, 7.5F);
        return 0.5F - colors_at(seen, ray, tracer.closest_hit(ray, RayMask::kCamera), share).albedo.y;
    }
    // Of the pixel in the middle, when asked for that many.
    std::uint32_t samples(std::uint32_t asked) {
        const RayTracer tracer(scene_, control_);
        return trace_tile(view(tracer, asked), {0, 0, kPixels, kPixels}).pixels[8 * kPixels + 8].samples;
    }

    Scene scene_;
    CameraDescription camera_;

  private:
    View view(const RayTracer& tracer, std::uint32_t samples) {
        return {scene_,
                tracer,
                *colors_,
                PixelCamera(camera_, kPixels, kPixels),
                PixelFilter(FilterType::kBox, 1),
                {{0, 0, kPixels, kPixels}, samples, 1, false}};
    }

    Control control_;
    Messages messages_;
    std::vector<float> pixels_;
    TextureSet textures_;
    std::unique_ptr<SurfaceColors> colors_;
};

// A sample's width in texels is 4 sqrt(share): stripes blend with their mean from one texel to two.
TEST_F(SampleColorTest, a_sample_is_as_wide_as_the_root_of_its_share) {
    EXPECT_NEAR(contrast(1), 0, 0.01F);
    EXPECT_NEAR(contrast(1 / 4.0F), 0, 0.01F);
    EXPECT_NEAR(contrast(9 / 64.0F), 0.15F, 0.01F);  // 1.5 texels
    EXPECT_NEAR(contrast(1 / 16.1F), 0.3F, 0.01F);
    EXPECT_NEAR(contrast(1 / 128.0F), 0.3F, 0.01F);
}

// A pixel that shows several colours has more samples: with 4 to begin with stripes are averaged, with 16 they are not.
TEST_F(SampleColorTest, samples_of_a_pixel_share_its_area) {
    EXPECT_EQ(samples(4), 4U);
    EXPECT_EQ(samples(16), 64U);
}

// Twice as far away it covers twice as many texels.
TEST_F(SampleColorTest, a_sample_grows_with_the_distance) {
    camera_.to_world.translation = {0, 0, 1};
    camera_.window[0] = camera_.window[2] = -0.25F;
    camera_.window[1] = camera_.window[3] = 0.25F;
    EXPECT_NEAR(contrast(9 / 64.0F), 0.15F, 0.01F);
    camera_.window[0] = camera_.window[2] = -0.5F;
    camera_.window[1] = camera_.window[3] = 0.5F;
    EXPECT_NEAR(contrast(1 / 16.0F), 0, 0.01F);
}

}  // namespace
}  // namespace gg
