#include "film/solution_view.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "core/control.h"
#include "core/messages.h"
#include "core/parallel.h"
#include "gridgather.h"
#include "material/surface_color.h"

namespace gg {
namespace {

constexpr std::uint32_t kWidth = 96;
constexpr std::uint32_t kHeight = 80;

// A sphere of radius 1 around the origin, seen from 3 m by a camera that looks along -Z.
Scene sphere_scene() {
    constexpr std::uint32_t kRings = 64;
    constexpr std::uint32_t kSides = 128;
    Mesh mesh;
    for (std::uint32_t ring = 0; ring <= kRings; ++ring) {
        for (std::uint32_t side = 0; side < kSides; ++side) {
            const float polar = kPi * static_cast<float>(ring) / kRings;
            const float around = 2 * kPi * static_cast<float>(side) / kSides;
            mesh.positions.push_back(
                {std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar)});
        }
    }
    for (std::uint32_t ring = 0; ring < kRings; ++ring) {
        for (std::uint32_t side = 0; side < kSides; ++side) {
            const std::uint32_t next = (side + 1) % kSides;
            mesh.triangles.push_back({ring * kSides + side, (ring + 1) * kSides + side, (ring + 1) * kSides + next});
            mesh.triangles.push_back({ring * kSides + side, (ring + 1) * kSides + next, ring * kSides + next});
        }
    }
    Scene scene;
    scene.meshes = {mesh};
    scene.instances.resize(1);
    scene.material_lists = {{0}};
    scene.materials.resize(1);
    scene.materials[0].reflectance.factor = {0.5F, 0.25F, 0.75F};
    scene.materials[0].emission.factor = {0.1F, 0, 0};
    scene.world = {2, 3, 4};
    return scene;
}

struct Picture {
    std::vector<Rgba> pixels = std::vector<Rgba>(kWidth * kHeight);
    ViewCounts counts;

    [[nodiscard]] const Rgba& at(std::uint32_t x, std::uint32_t y) const { return pixels[y * kWidth + x]; }
};

class SolutionViewTest : public ::testing::Test {
  protected:
    Picture render(const Scene& scene, const IrradianceAt& irradiance_at, ViewSettings settings = {}) {
        CameraDescription camera;
        camera.to_world.translation = {0, 0, 3};
        const float window[4] = {-0.6F, 0.6F, -0.5F, 0.5F};
        std::copy(std::begin(window), std::end(window), camera.window);
        const RayTracer tracer(scene, control_);
        const TextureSet textures;
        const SurfaceColors colors(scene, textures, messages_);
        if (settings.crop.width == 0) {
            settings.crop = {0, 0, kWidth, kHeight};
        }
        const View view{scene,
                        tracer,
                        colors,
                        PixelCamera(camera, kWidth, kHeight),
                        PixelFilter(FilterType::kBlackmanHarris, 1.5F),
                        settings};
        Film film(settings.crop.width, settings.crop.height);
        Picture picture;
        picture.counts = render_view(view, irradiance_at, film, control_);
        picture.pixels.resize(settings.crop.width * settings.crop.height);
        film.read({0, 0, settings.crop.width, settings.crop.height}, picture.pixels);
        return picture;
    }

    Control control_;
    Messages messages_;
};

Rgb uniform(const Hit&, bool) {
    return Rgb(kPi);
}

Rgb varied(const Hit& hit, bool) {
    return {hit.u + 0.1F, hit.v + 0.2F, static_cast<float>(hit.triangle % 7)};
}

TEST_F(SolutionViewTest, a_sphere_in_uniform_irradiance_shows_reflectance_plus_emission) {
    const Picture picture = render(sphere_scene(), uniform);
    const Rgba centre = picture.at(kWidth / 2, kHeight / 2);
    EXPECT_NEAR(centre.color.r, 0.6F, 1e-5F);
    EXPECT_NEAR(centre.color.g, 0.25F, 1e-5F);
    EXPECT_NEAR(centre.color.b, 0.75F, 1e-5F);
    EXPECT_FLOAT_EQ(centre.alpha, 1);
    EXPECT_NEAR(picture.at(0, 0).color.b, 4, 1e-5F);
    EXPECT_FLOAT_EQ(picture.at(0, 0).alpha, 1);
    EXPECT_EQ(picture.counts.samples, 16U * kWidth * kHeight);
    EXPECT_EQ(picture.counts.dropped, 0U);
}

TEST_F(SolutionViewTest, coverage_equals_the_spheres_solid_angle_in_the_window) {
    ViewSettings settings;
    settings.film_transparent = true;
    const Picture picture = render(sphere_scene(), uniform, settings);
    double covered = 0;
    for (const Rgba& pixel : picture.pixels) {
        covered += pixel.alpha;
        EXPECT_NEAR(pixel.color.g, 0.25F * pixel.alpha, 1e-5F);
    }
    // Tangent cone at distance 3: the disk in the plane at distance 1 has radius 1 / sqrt(8).
    const double pixels = kPi / 8 / (1.2 / kWidth * 1.0 / kHeight);
    EXPECT_NEAR(covered, pixels, 0.003 * pixels);
}

TEST_F(SolutionViewTest, exposure_scales_colour_alone) {
    ViewSettings settings;
    settings.exposure = 0.5F;
    const Picture picture = render(sphere_scene(), uniform, settings);
    EXPECT_NEAR(picture.at(0, 0).color.r, 1, 1e-5F);
    EXPECT_NEAR(picture.at(kWidth / 2, kHeight / 2).color.g, 0.125F, 1e-5F);
    EXPECT_FLOAT_EQ(picture.at(0, 0).alpha, 1);
}

TEST_F(SolutionViewTest, the_inside_is_the_back) {
    Scene scene = sphere_scene();
    const IrradianceAt sides = [](const Hit&, bool back) { return back ? Rgb(0, kPi, 0) : Rgb(kPi, 0, 0); };
    EXPECT_NEAR(render(scene, sides).at(kWidth / 2, kHeight / 2).color.r, 0.6F, 1e-5F);
    scene.instances[0].to_world.linear = Mat3(5);
    scene.instances[0].normal_to_world = normal_matrix(Mat3(5));
    EXPECT_NEAR(render(scene, sides).at(kWidth / 2, kHeight / 2).color.g, 0.25F, 1e-5F);
}

TEST_F(SolutionViewTest, instances_hidden_from_the_camera_are_not_seen) {
    Scene scene = sphere_scene();
    scene.instances[0].flags = GG_HIDDEN_FROM_CAMERA;
    EXPECT_NEAR(render(scene, uniform).at(kWidth / 2, kHeight / 2).color.b, 4, 1e-5F);
}

TEST_F(SolutionViewTest, samples_that_are_not_finite_are_dropped_and_counted) {
    const IrradianceAt broken = [](const Hit& hit, bool) {
        return Rgb(hit.triangle % 2 == 0 ? std::numeric_limits<float>::quiet_NaN() : kPi);
    };
    const Picture picture = render(sphere_scene(), broken);
    EXPECT_GT(picture.counts.dropped, 1000U);
    for (const Rgba& pixel : picture.pixels) {
        EXPECT_TRUE(is_finite(pixel.color));
    }
}

TEST_F(SolutionViewTest, the_number_of_threads_changes_no_byte) {
    const Scene scene = sphere_scene();
    const Picture expected = render(scene, varied);
    for (const int threads : {1, 2, 7}) {
        run_with_threads(threads, [&] {
            const Picture picture = render(scene, varied);
            EXPECT_EQ(std::memcmp(picture.pixels.data(), expected.pixels.data(), picture.pixels.size() * sizeof(Rgba)),
                      0);
        });
    }
}

TEST_F(SolutionViewTest, a_crop_shows_what_the_full_picture_shows) {
    const Scene scene = sphere_scene();
    const Picture full = render(scene, varied);
    ViewSettings settings;
    settings.crop = {20, 30, 41, 37};
    const Picture crop = render(scene, varied, settings);
    for (std::uint32_t y = 0; y < 37; ++y) {
        EXPECT_EQ(std::memcmp(&crop.pixels[y * 41], &full.at(20, 30 + y), 41 * sizeof(Rgba)), 0);
    }
}

TEST_F(SolutionViewTest, a_cancelled_picture_throws_cancelled) {
    const IrradianceAt cancelling = [&](const Hit&, bool) {
        control_.cancel();
        return Rgb(0);
    };
    EXPECT_THROW(render(sphere_scene(), cancelling), Cancelled);
}

}  // namespace
}  // namespace gg
