// Shading in batches is what every site says alone, ray by ray.
#include "oracles/site_irradiance.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/gather_scenes.h"
#include "support/grid_picture.h"

namespace gg::test {
namespace {

constexpr std::size_t kPoints = 300;

// What the sites of all points hold.
struct Holds {
    std::size_t both = 0, only_visibility = 0, only_form_factor = 0, beams = 0, leaves = 0, near_cells = 0,
                close_cells = 0;

    void add(const Site& site) {
        for (const SiteSender& sender : site.senders) {
            both += sender.resample_form_factor && sender.resample_visibility;
            only_visibility += !sender.resample_form_factor;
            only_form_factor += !sender.resample_visibility;
        }
        beams += site.beams.size();
        leaves += site.leaves.size();
        near_cells += site.near_cells.count();
        close_cells += site.close_cells.count();
    }
};

Holds expect_equal(const ViewedScene& scene, float threshold) {
    PictureSettings settings;
    settings.threshold = threshold;
    const GridPicture picture(scene.description, scene.camera, settings);
    std::vector<PlacedFragment> placed;
    Holds holds;
    for (const Fragment& at : picture.some_fragments(kPoints)) {
        placed.push_back(picture.place(at));
        for (const WeightedSite& weighted : placed.back().sites()) {
            holds.add(*weighted.site);
        }
    }
    EXPECT_GE(placed.size(), kPoints);
    Shader shader = picture.shader();
    const std::vector<Rgb> light = light_at(shader, placed);
    double mean = 0;
    for (const Rgb& at : light) {
        mean += static_cast<double>(luminance(at)) / static_cast<double>(light.size());
    }
    const oracle::ShadedScene shaded{*picture.solution, picture.points, *picture.prepared.tracer};
    for (std::size_t i = 0; i < placed.size(); ++i) {
        const Vec3d expected = oracle::site_irradiance(shaded, placed[i]);
        for (int channel = 0; channel < 3; ++channel) {
            // In dark places what is near cancels the light of tables.
            EXPECT_NEAR(light[i][channel], expected[channel], 1e-5 * expected[channel] + 1e-6 * mean) << i;
        }
    }
    return holds;
}

// All that matters is resampled.
TEST(SiteIrradiance, of_threshold_zero_is_that_of_its_rays) {
    for (const ViewedScene& scene : {viewed_lamp_room(), viewed_mixed_scene(), viewed_window_room()}) {
        EXPECT_GT(expect_equal(scene, 0).both, 50'000U);
    }
    EXPECT_GT(expect_equal(viewed_jungle(1000), 0).leaves, 50'000U);
}

// Some is interpolated, in part or as a whole.
TEST(SiteIrradiance, of_the_default_is_that_of_its_rays) {
    const Holds lamp = expect_equal(viewed_lamp_room(), 0.03F), mixed = expect_equal(viewed_mixed_scene(), 0.03F),
                window = expect_equal(viewed_window_room(), 0.03F), jungle = expect_equal(viewed_jungle(1000), 0.03F);
    EXPECT_GT(lamp.both, 1000U);
    EXPECT_GT(lamp.only_form_factor, 100U);
    EXPECT_GT(mixed.only_visibility, 100U);
    EXPECT_GT(mixed.beams, 100U);
    EXPECT_GT(window.leaves, 10'000U);
    EXPECT_GT(jungle.near_cells, 10'000U);
    EXPECT_GT(jungle.close_cells, 500U);
}

}  // namespace
}  // namespace gg::test
