#include "gather/site_thresholds.h"

#include <gtest/gtest.h>

#include "core/control.h"
#include "film/radiosity_view.h"
#include "gather/receiver.h"
#include "perception/tvi.h"
#include "support/gather_scenes.h"
#include "support/grid_picture.h"

namespace gg::test {
namespace {

// A display without a view transform, with white at 1.
Observer observer() {
    Observer observer;
    observer.display = [](std::span<Rgb> pixels) {
        for (Rgb& pixel : pixels) {
            pixel = glm::clamp(pixel, Rgb(0.0F), Rgb(1.0F));
        }
    };
    return observer;
}

// On a display that is linear the answer is the threshold itself.
TEST(SiteThresholds, of_a_linear_display_are_known) {
    const std::vector<SiteView> sites{{Rgb(0.5F), 50, 1}, {Rgb(0.2F, 0.3F, 0.1F), 20, 3}, {Rgb(0.01F), 1.2F, 1}};
    const auto errors = noticeable_radiosity(observer(), sites, 1, Control());
    for (std::size_t i = 0; i < sites.size(); ++i) {
        const float expected = kPi * 0.25F * just_noticeable(sites[i].adaptation) * sites[i].elevation / 100;
        EXPECT_NEAR(errors[i], expected, 0.003F * expected) << i;
    }
}

TEST(SiteThresholds, count_in_light_before_exposure) {
    const std::vector<SiteView> sites{{Rgb(0.25F), 50, 1}}, brighter{{Rgb(0.5F), 50, 1}};
    EXPECT_NEAR(2 * noticeable_radiosity(observer(), sites, 2, Control())[0],
                noticeable_radiosity(observer(), brighter, 1, Control())[0], 1e-5F);
}

// A view transform that presses highlights together allows more there.
TEST(SiteThresholds, are_judged_as_they_are_shown) {
    Observer soft = observer();
    soft.display = [](std::span<Rgb> pixels) {
        for (Rgb& pixel : pixels) {
            pixel = pixel / (pixel + Rgb(1.0F));
        }
    };
    const std::vector<SiteView> sites{{Rgb(0.1F), 30, 1}, {Rgb(3), 30, 1}};
    const auto errors = noticeable_radiosity(soft, sites, 1, Control());
    EXPECT_NEAR(errors[1] / errors[0], 16 / 1.21F, 1);  // squares of 1 + luminance: the slopes
}

TEST(SiteThresholds, are_positive_where_there_is_any_light) {
    const std::vector<SiteView> sites{{Rgb(0.5F), 50, 1}, {Rgb(0.0F), 0.2F, 1}, {Rgb(100.0F), 100, 10}};
    for (const float error : noticeable_radiosity(observer(), sites, 1, Control())) {
        EXPECT_GT(error, 0);
        EXPECT_LT(error, 4.001F * kPi * 100);
    }
}

TEST(SiteThresholds, stop_when_cancelled) {
    Control control;
    control.cancel();
    const std::vector<SiteView> sites{{Rgb(0.5F), 50, 1}};
    EXPECT_THROW((void)noticeable_radiosity(observer(), sites, 1, control), Cancelled);
}

// Means over fragments, held against a sum over all of them; the picture's own pixels are what masks.
TEST(SiteThresholds, sites_know_what_is_seen_around_them) {
    const ViewedScene scene = viewed_lamp_room();
    const GridPicture picture(scene.description, scene.camera, {});
    const Control control;
    const MaskingMap seen = observe(observer(), *picture.solution, picture.view, picture.tiles, control);
    const SiteReceivers receivers(*picture.solution, picture.view, picture.places, picture.tiles, &seen, control);
    ASSERT_EQ(receivers.views().size(), receivers.site_count());
    Observer unmasked = observer();
    unmasked.masking = false;
    for (const float elevation : observe(unmasked, *picture.solution, picture.view, picture.tiles, control).elevation) {
        ASSERT_EQ(elevation, 1);
    }
    std::size_t checked = 0;
    for (std::size_t site = 0; site < receivers.site_count(); site += 37) {
        double weight = 0, adaptation = 0, sensitivity = 0, green = 0;
        for (const TileFragments& tile : picture.tiles) {
            for (std::size_t p = 0; p < tile.pixels.size(); ++p) {
                const std::size_t x = tile.tile.x + p % tile.tile.width, y = tile.tile.y + p / tile.tile.width;
                for (std::uint32_t f = tile.begin_of(p); f < tile.pixels[p].end; ++f) {
                    const Fragment& at = tile.fragments[f];
                    const SitePlace place = picture.places.of(at);
                    if (std::count(place.vertices.begin(), place.vertices.begin() + place.count,
                                   receivers.vertex_of(site)) > 0) {
                        const Rgb light = irradiance_at(*picture.solution, at);
                        weight += static_cast<double>(at.share);
                        adaptation += static_cast<double>(at.share * seen.adaptation[y * seen.width + x]);
                        sensitivity +=
                            static_cast<double>(at.share) * std::pow(seen.elevation[y * seen.width + x], -4.0);
                        green += static_cast<double>(at.albedo.g * light.g / kPi);
                    }
                }
            }
        }
        const SiteView& view = receivers.views()[site];
        EXPECT_NEAR(view.adaptation / (adaptation / weight), 1, 1e-4) << site;
        EXPECT_NEAR(std::pow(view.elevation, 4.0) * sensitivity / weight, 1, 1e-3) << site;
        EXPECT_NEAR(view.radiance.g / (green / weight), 1, 1e-4) << site;
        ++checked;
    }
    EXPECT_GT(checked, 10U);
}

// Every pixel is what the solution says of it.
TEST(RadiosityView, is_the_picture_of_the_solution) {
    const ViewedScene scene = viewed_lamp_room();
    const GridPicture picture(scene.description, scene.camera, {});
    const auto half = [](const Fragment&) { return Rgb(kPi / 2); };
    const std::vector<Rgb> pixels = radiosity_view(picture.view, picture.tiles, half, Control());
    const TileFragments& tile = picture.tiles.back();
    for (std::size_t p = 0; p < tile.pixels.size(); ++p) {
        Rgb expected = tile.pixels[p].emitted;
        for (std::uint32_t f = tile.begin_of(p); f < tile.pixels[p].end; ++f) {
            expected += 0.5F * tile.fragments[f].albedo;
        }
        const std::size_t x = tile.tile.x + p % tile.tile.width, y = tile.tile.y + p / tile.tile.width;
        EXPECT_NEAR(pixels[y * picture.view.settings.crop.width + x].g, expected.g, 1e-4F * expected.g + 1e-6F);
    }
}

}  // namespace
}  // namespace gg::test
