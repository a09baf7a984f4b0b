#include "gather/shared_light.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "core/control.h"
#include "core/statistics.h"
#include "gather/render_gather.h"
#include "support/gather_scenes.h"
#include "support/grid_picture.h"

namespace gg::test {
namespace {

constexpr float kTolerance = 0.03F;

TEST(SharingStages, every_pixel_has_one_turn_after_those_around_it) {
    constexpr std::uint32_t kWidth = 11, kHeight = 7;
    for (const int spacing : {1, 2, 4, 8}) {
        std::map<std::uint32_t, std::size_t> turns;
        const std::vector<SharingStage> stages = sharing_stages(kWidth, kHeight, spacing);
        for (std::size_t s = 0; s < stages.size(); ++s) {
            for (const std::uint32_t pixel : stages[s].pixels) {
                EXPECT_TRUE(turns.emplace(pixel, s).second) << pixel;
            }
        }
        EXPECT_EQ(turns.size(), kWidth * kHeight);
        for (std::size_t s = 0; s < stages.size(); ++s) {
            EXPECT_EQ(stages[s].across.size(), s == 0 ? 0U : 2U);
            for (const std::uint32_t pixel : stages[s].pixels) {
                for (const SharingStage::Step& step : stages[s].across) {
                    for (const int sign : {-1, 1}) {
                        const int x = static_cast<int>(pixel % kWidth) + sign * step.x;
                        const int y = static_cast<int>(pixel / kWidth) + sign * step.y;
                        if (x >= 0 && y >= 0 && x < static_cast<int>(kWidth) && y < static_cast<int>(kHeight)) {
                            EXPECT_LT(turns.at(static_cast<std::uint32_t>(y) * kWidth + x), s);
                        }
                    }
                }
            }
        }
    }
}

TEST(SharingStages, pixels_of_a_square_follow_one_another) {
    const std::vector<SharingStage> all = sharing_stages(4, 4, 1);
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].pixels, (std::vector<std::uint32_t>{0, 1, 4, 5, 2, 3, 6, 7, 8, 9, 12, 13, 10, 11, 14, 15}));
}

TEST(SharingStages, spacing_follows_the_cells) {
    EXPECT_EQ(sharing_in(10, 0.03F).spacing, 1);
    EXPECT_EQ(sharing_in(19.9F, 0.03F).spacing, 1);
    EXPECT_EQ(sharing_in(20, 0.03F).spacing, 2);
    EXPECT_EQ(sharing_in(79, 0.03F).spacing, 2);
    EXPECT_EQ(sharing_in(80, 0.03F).spacing, 4);
    EXPECT_EQ(sharing_in(320, 0.03F).spacing, 8);
    EXPECT_EQ(sharing_in(20, 0.01F).tolerance, 0.01F);
}

// Three by three pixels of a floor, a metre apart; the one in the middle looks at those beside it, above and below.
struct Floor {
    static constexpr std::uint32_t kLeft = 3, kMiddle = 4, kRight = 5, kBelow = 1, kAbove = 7;
    TileFragments tile{{0, 0, 3, 3}, {}, {}};
    std::vector<PointLight> light{9};
    SharingStage stage{{kMiddle}, {{1, 0}, {0, 1}}};

    Floor() {
        for (std::uint32_t p = 0; p < 9; ++p) {
            Fragment fragment;
            fragment.hit.instance = 3;
            fragment.position = {static_cast<float>(p % 3), static_cast<float>(p / 3), 0};
            fragment.normal = fragment.shading_normal = {0, 0, 1};
            fragment.share = 1;
            tile.fragments.push_back(fragment);
            tile.pixels.push_back({p + 1, 16, Rgb(0.0F), 1, 1});
            light[p].all = Rgb(1.0F);
        }
    }

    [[nodiscard]] KnownLight known() const { return shared_light(tile, light, stage, kMiddle, kMiddle, kTolerance); }
};

TEST(SharedLight, is_linear_between_neighbours) {
    Floor floor;
    // Off the middle, as what is seen of a pixel may lie.
    floor.tile.fragments[Floor::kMiddle].position = {1.25F, 0.9F, 0};
    for (std::uint32_t p = 0; p < 9; ++p) {
        const Vec3 at = floor.tile.fragments[p].position;
        floor.light[p].soft = Rgb(0.3F + 0.02F * at.x, 0.4F, 0.1F);
        floor.light[p].sky = Rgb(0.2F, 0.2F + 0.01F * at.y, 0.2F);
    }
    const KnownLight known = floor.known();
    ASSERT_TRUE(known.soft && known.sky);
    // The pair above and below has the middle's x.
    EXPECT_NEAR(known.soft->x, 0.3F + 0.02F * (0.5F * 1.25F + 0.5F * 1.0F), 1e-6F);
    EXPECT_NEAR(known.soft->y, 0.4F, 1e-6F);
    EXPECT_NEAR(known.sky->y, 0.2F + 0.01F * (0.5F * 0.9F + 0.5F * 1.0F), 1e-6F);
}

TEST(SharedLight, neighbours_must_agree) {
    Floor floor;
    floor.light[Floor::kLeft].soft = Rgb(0.04F);
    EXPECT_TRUE(floor.known().soft);
    EXPECT_TRUE(floor.known().sky);
    floor.light[Floor::kLeft].soft = Rgb(0.06F);
    EXPECT_FALSE(floor.known().soft);
    EXPECT_TRUE(floor.known().sky);
    floor.light[Floor::kAbove].sky = Rgb(0.04F);
    EXPECT_FALSE(floor.known().sky);
    // In twice the light the same differences count half.
    for (PointLight& light : floor.light) {
        light.all *= 2.0F;
    }
    EXPECT_TRUE(floor.known().soft && floor.known().sky);
}

TEST(SharedLight, other_surfaces_share_nothing) {
    Floor floor;
    for (const std::uint32_t p : {Floor::kLeft, Floor::kRight, Floor::kBelow}) {
        floor.tile.fragments[p].hit.instance = 4;
    }
    floor.light[Floor::kAbove].soft = Rgb(0.5F);
    EXPECT_FALSE(floor.known().soft);  // one neighbour tells nothing of how light changes
    floor.tile.fragments[Floor::kLeft].hit.instance = 3;
    floor.light[Floor::kLeft].soft = Rgb(0.52F);
    ASSERT_TRUE(floor.known().soft);  // two at a corner do
    EXPECT_NEAR(floor.known().soft->x, 0.51F, 1e-6F);
    EXPECT_TRUE(floor.known().glowing.empty());
}

TEST(SharedLight, the_first_stage_shares_nothing) {
    Floor floor;
    floor.stage.across.clear();
    EXPECT_FALSE(floor.known().soft || floor.known().sky);
}

// At the rim of a tile as at the rim of a surface.
TEST(SharedLight, nothing_lies_beyond_the_tile) {
    Floor floor;
    floor.stage.across = {{2, 0}, {0, 2}};
    EXPECT_FALSE(floor.known().soft);
}

TEST(SharedLight, senders_are_shared_that_all_see_alike) {
    Floor floor;
    for (PointLight& light : floor.light) {
        // Of the bright one half is seen, of the dim ones what each case says.
        light.glowing = {{2, 0.5F, 1}, {5, 0.25F, 0.02F}, {9, 0.1F, 1}};
    }
    floor.light[Floor::kLeft].glowing[0].visibility = 0.52F;
    floor.light[Floor::kLeft].glowing[1].visibility = 1;     // too dim to tell
    floor.light[Floor::kLeft].glowing[2].visibility = 0.2F;  // a shadow begins
    std::vector<SeenSender> glowing = floor.known().glowing;
    ASSERT_EQ(glowing.size(), 2U);
    EXPECT_EQ(glowing[0].sender, 2U);
    EXPECT_NEAR(glowing[0].visibility, 0.505F, 1e-6F);
    EXPECT_EQ(glowing[1].sender, 5U);
    EXPECT_NEAR(glowing[1].visibility, 0.4375F, 1e-6F);
    floor.light[Floor::kAbove].glowing.erase(floor.light[Floor::kAbove].glowing.begin());
    glowing = floor.known().glowing;
    ASSERT_EQ(glowing.size(), 1U);
    EXPECT_EQ(glowing[0].sender, 5U);
}

// Shadows may end where a surface does.
TEST(SharedLight, senders_are_shared_only_amid_the_surface) {
    Floor floor;
    for (PointLight& light : floor.light) {
        light.glowing = {{2, 0.5F, 1}};
    }
    EXPECT_EQ(floor.known().glowing.size(), 1U);
    floor.tile.fragments[Floor::kAbove].hit.instance = 4;
    EXPECT_TRUE(floor.known().glowing.empty());
    EXPECT_TRUE(floor.known().soft);
}

// All of the picture with what is shared, and without.
TEST(SharedLight, pictures_stay_as_they_are_for_fewer_rays) {
    PictureSettings settings;
    settings.height = 96;
    const ViewedScene scene = viewed_furnished_room();
    const GridPicture picture(scene.description, scene.camera, settings);
    struct Rendered {
        std::vector<Rgba> pixels;
        double near_rays = 0, visibility_rays = 0, sharing = 0;
    };
    const auto render = [&](bool shared) {
        GatherSettings gather;
        gather.shared = shared;
        gather.cell = 20.0F * 350 / static_cast<float>(settings.height);
        Film film(settings.width, settings.height);
        Control control;
        Statistics statistics;
        grid_gather(*picture.solution, picture.view, gather, nullptr, settings.width, settings.height, film, control,
                    statistics);
        const std::string json = statistics.json();
        const auto count = [&](const std::string& name) {
            return std::stod(json.substr(json.find("\"" + name + "\":") + name.size() + 3));
        };
        Rendered rendered{{}, count("near rays"), count("visibility rays"), count("fragments that share soft light")};
        rendered.pixels.resize(std::size_t{settings.width} * settings.height);
        film.read({0, 0, settings.width, settings.height}, rendered.pixels);
        return rendered;
    };
    const Rendered alone = render(false), shared = render(true);
    double difference = 0, sum = 0;
    for (std::size_t p = 0; p < alone.pixels.size(); ++p) {
        difference += std::abs(luminance(shared.pixels[p].color - alone.pixels[p].color));
        sum += luminance(alone.pixels[p].color);
    }
    EXPECT_LT(difference, 0.005 * sum);
    EXPECT_GT(difference, 0);
    EXPECT_LT(shared.near_rays, 0.7 * alone.near_rays);
    EXPECT_LT(shared.visibility_rays, 0.8 * alone.visibility_rays);
    EXPECT_EQ(alone.sharing, 0);
    EXPECT_GT(shared.sharing, 0.3 * static_cast<double>(alone.pixels.size()));
}

}  // namespace
}  // namespace gg::test
