#include "scene/load_textures.h"

#include <gtest/gtest.h>

#include "core/control.h"
#include "core/messages.h"

namespace gg {
namespace {

ImageDescription two_texels(Extension extension, FilterMode filter, ColorSpace space) {
    ImageDescription image;
    image.name = "image";
    image.pixels = {0.5F, 0.5F, 0.5F, 1, 1, 1, 1, 1};
    image.width = 2;
    image.height = 1;
    image.extension = extension;
    image.filter_mode = filter;
    image.color_space = space;
    return image;
}

TEST(LoadTextures, every_setting_of_the_description_reaches_the_lookup) {
    SceneDescription description;
    description.images = {two_texels(Extension::kRepeat, FilterMode::kLinear, ColorSpace::kLinear),
                          two_texels(Extension::kExtend, FilterMode::kLinear, ColorSpace::kLinear),
                          two_texels(Extension::kClip, FilterMode::kLinear, ColorSpace::kLinear),
                          two_texels(Extension::kMirror, FilterMode::kLinear, ColorSpace::kLinear),
                          two_texels(Extension::kRepeat, FilterMode::kClosest, ColorSpace::kLinear),
                          two_texels(Extension::kRepeat, FilterMode::kLinear, ColorSpace::kSrgb)};
    Messages messages;
    const TextureSet textures = load_textures(description, Control{}, messages);
    ASSERT_EQ(textures.size(), 6U);
    EXPECT_TRUE(messages.all().empty());
    const Vec2 outside(1.25F, 0.5F);
    EXPECT_NEAR(textures.lookup(0, outside, 0).g, 0.5, 1e-3);
    EXPECT_EQ(textures.lookup(1, outside, 0).g, 1);
    EXPECT_EQ(textures.lookup(2, outside, 0).g, 0);
    EXPECT_EQ(textures.lookup(3, outside, 0).g, 1);
    EXPECT_NEAR(textures.lookup(4, {0.45F, 0.5F}, 0).g, 0.5, 1e-3);
    EXPECT_NEAR(textures.lookup(5, {0.25F, 0.5F}, 0).g, 0.2140, 1e-3);
}

TEST(LoadTextures, a_path_goes_before_pixels) {
    SceneDescription description;
    description.images = {two_texels(Extension::kRepeat, FilterMode::kLinear, ColorSpace::kLinear)};
    description.images[0].path = "/nowhere/image.png";
    Messages messages;
    EXPECT_EQ(load_textures(description, Control{}, messages).lookup(0, {0, 0}, 0), Rgb(1, 0, 1));
    EXPECT_EQ(messages.all().size(), 1U);
}

}  // namespace
}  // namespace gg
