// What sites decide about senders.
#include "gather/classify.h"

#include <gtest/gtest.h>

#include "support/gather_scenes.h"
#include "support/grid_picture.h"

namespace gg::test {
namespace {

// In eq. 1 samples go by importance alone; where all rays agreed, a quarter of them is enough.
TEST(Classify, senders_that_are_all_seen_or_all_hidden_have_a_quarter_of_the_samples) {
    const ViewedScene scene = viewed_lamp_room();
    PictureSettings settings;
    settings.threshold = 0.003F;
    const GridPicture picture(scene.description, scene.camera, settings);
    std::size_t agreed = 0, mixed = 0;
    for (const Site& site : picture.sites) {
        float each = 0;  // irradiance of a sender, per sample, if some of its rays met something
        for (const SiteSender& sender : site.senders) {
            if (sender.visibility > 0 && sender.visibility < 1 && sender.samples > 1) {
                const float irradiance = luminance(sender.irradiance) / sender.samples;
                each = each > 0 ? each : irradiance;
                EXPECT_NEAR(irradiance / each, 1, 1e-4F);
                ++mixed;
            }
        }
        for (const SiteSender& sender : site.senders) {
            if ((sender.visibility == 0 || sender.visibility == 1) && sender.samples > 1 && each > 0) {
                EXPECT_NEAR(luminance(sender.irradiance) / sender.samples / each, 4, 4e-4F);
                ++agreed;
            }
        }
    }
    EXPECT_GT(mixed, 1000U);
    EXPECT_GT(agreed, 100U);
}

}  // namespace
}  // namespace gg::test
