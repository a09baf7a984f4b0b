#include "image/texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/control.h"
#include "core/messages.h"
#include "core/parallel.h"
#include "core/random.h"
#include "support/image_files.h"

namespace gg {
namespace {

using test::TempFile;

// Grey linear pixels, bottom row first. 1.5 and the like keep them from being stored as bytes.
struct Pixels {
    std::vector<float> values;
    ImageSource source;

    Pixels(std::uint32_t width, std::uint32_t height, const std::vector<float>& grey) {
        for (const float value : grey) {
            values.insert(values.end(), {value, value, value, 1.0F});
        }
        source.name = "pixels";
        source.pixels = values;
        source.width = width;
        source.height = height;
        source.srgb = false;
    }
    Pixels(const Pixels&) = delete;
    Pixels& operator=(const Pixels&) = delete;
};

TextureSet make_set(const ImageSource& source, Messages& messages,
                    std::size_t limit = TextureSet::kDefaultMemoryLimit) {
    return {std::span(&source, 1), Control{}, messages, limit};
}

float grey_at(const ImageSource& source, Vec2 uv, float width = 0) {
    Messages messages;
    const Rgb color = make_set(source, messages).lookup(0, uv, width);
    EXPECT_TRUE(messages.all().empty());
    return color.g;
}

TEST(Texture, texel_centres_have_the_texels_values_with_v_up) {
    const Pixels pixels(2, 2, {0.25F, 0.5F, 1.5F, 2});
    EXPECT_FLOAT_EQ(grey_at(pixels.source, {0.25F, 0.25F}), 0.25F);
    EXPECT_FLOAT_EQ(grey_at(pixels.source, {0.75F, 0.25F}), 0.5F);
    EXPECT_FLOAT_EQ(grey_at(pixels.source, {0.25F, 0.75F}), 1.5F);
    EXPECT_FLOAT_EQ(grey_at(pixels.source, {0.75F, 0.75F}), 2);
}

TEST(Texture, linear_filter_is_bilinear_between_centres) {
    const Pixels pixels(2, 2, {0.25F, 0.5F, 1.5F, 2});
    EXPECT_NEAR(grey_at(pixels.source, {0.5F, 0.25F}), 0.375, 1e-6);
    EXPECT_NEAR(grey_at(pixels.source, {0.5F, 0.5F}), (0.25 + 0.5 + 1.5 + 2) / 4, 1e-6);
    EXPECT_NEAR(grey_at(pixels.source, {0.375F, 0.25F}), 0.25 + 0.25 * 0.25, 1e-6);
}

TEST(Texture, closest_filter_has_squares_of_one_colour) {
    Pixels pixels(2, 1, {0.25F, 1.5F});
    pixels.source.closest = true;
    EXPECT_EQ(grey_at(pixels.source, {0.01F, 0.9F}), 0.25F);
    EXPECT_EQ(grey_at(pixels.source, {0.49F, 0.1F}), 0.25F);
    EXPECT_EQ(grey_at(pixels.source, {0.51F, 0.1F}), 1.5F);
    pixels.source.wrap = Wrap::kExtend;
    EXPECT_EQ(grey_at(pixels.source, {1, 1}), 1.5F);
}

TEST(Texture, repeat_goes_on_with_the_image_and_joins_its_borders) {
    const Pixels pixels(4, 1, {0.25F, 0.5F, 1, 2});
    for (const float turns : {-2.0F, -1.0F, 1.0F, 3.0F}) {
        EXPECT_NEAR(grey_at(pixels.source, {0.375F + turns, 0.5F}), 0.5, 1e-5);
    }
    EXPECT_NEAR(grey_at(pixels.source, {0, 0.5F}), (0.25 + 2) / 2, 1e-6);
    EXPECT_NEAR(grey_at(pixels.source, {1, 0.5F}), (0.25 + 2) / 2, 1e-6);
}

TEST(Texture, extend_goes_on_with_the_border) {
    Pixels pixels(4, 1, {0.25F, 0.5F, 1, 2});
    pixels.source.wrap = Wrap::kExtend;
    for (const float u : {-5.0F, 0.0F, 0.125F}) {
        EXPECT_EQ(grey_at(pixels.source, {u, 7}), 0.25F);
    }
    EXPECT_EQ(grey_at(pixels.source, {1.2F, 0.5F}), 2);
}

TEST(Texture, clip_is_black_outside_and_the_image_inside) {
    Pixels pixels(4, 1, {0.25F, 0.5F, 1, 2});
    pixels.source.wrap = Wrap::kClip;
    EXPECT_EQ(grey_at(pixels.source, {-0.01F, 0.5F}), 0);
    EXPECT_EQ(grey_at(pixels.source, {0.5F, 1.01F}), 0);
    EXPECT_EQ(grey_at(pixels.source, {0, 0.5F}), 0.25F);
    EXPECT_EQ(grey_at(pixels.source, {1, 1}), 2);
}

TEST(Texture, mirror_turns_round_at_every_integer) {
    Pixels pixels(4, 1, {0.25F, 0.5F, 1, 2});
    pixels.source.wrap = Wrap::kMirror;
    for (const float u : {-0.375F, 0.375F, 1.625F, 2.375F, -1.625F}) {
        EXPECT_NEAR(grey_at(pixels.source, {u, 0.5F}), 0.5, 1e-5) << u;
    }
    EXPECT_EQ(grey_at(pixels.source, {1, 0.5F}), 2);
}

TEST(Texture, srgb_is_decoded_before_filtering) {
    const TempFile file(".ppm");
    file.write(test::pixmap(2, 1, 3, 255, {128, 64, 255, 0, 0, 0}));
    ImageSource source;
    source.path = file.path();
    Messages messages;
    const TextureSet set = make_set(source, messages);
    const Rgb texel = set.lookup(0, {0.25F, 0.5F}, 0);
    EXPECT_NEAR(texel.r, std::pow((128 / 255.0 + 0.055) / 1.055, 2.4), 1e-6);
    EXPECT_NEAR(texel.g, std::pow((64 / 255.0 + 0.055) / 1.055, 2.4), 1e-6);
    EXPECT_EQ(texel.b, 1);
    EXPECT_NEAR(set.lookup(0, {0.5F, 0.5F}, 0).r, 0.5 * texel.r, 1e-6);
    source.srgb = false;
    EXPECT_FLOAT_EQ(make_set(source, messages).lookup(0, {0.25F, 0.5F}, 0).r, 128 / 255.0F);
    EXPECT_TRUE(messages.all().empty());
}

TEST(Texture, a_checkerboard_from_afar_is_half_in_linear_light) {
    const TempFile file(".ppm");
    std::vector<int> values;
    for (int index = 0; index < 64 * 64; ++index) {
        values.insert(values.end(), 3, (index % 64 + index / 64) % 2 ? 255 : 0);
    }
    file.write(test::pixmap(64, 64, 3, 255, values));
    ImageSource source;
    source.path = file.path();
    for (const float width : {1 / 32.0F, 1 / 8.0F, 0.4F, 1.0F, 100.0F, std::numeric_limits<float>::infinity()}) {
        EXPECT_NEAR(grey_at(source, {0.3F, 0.7F}, width), 0.5, 0.004) << width;
    }
}

TEST(Texture, width_blends_levels_without_jumps) {
    std::vector<float> grey;
    for (int index = 0; index < 64; ++index) {
        grey.push_back(2 * unit_float(hash64(static_cast<std::uint64_t>(index))));
    }
    const Pixels pixels(8, 8, grey);
    Messages messages;
    const TextureSet set = make_set(pixels.source, messages);
    float before = set.lookup(0, {0.3F, 0.6F}, 0).g;
    for (float width = 0.1F; width < 1.5F; width *= 1.01F) {
        const float now = set.lookup(0, {0.3F, 0.6F}, width).g;
        EXPECT_NEAR(now, before, 0.03) << width;
        before = now;
    }
}

// A width that covers w x h texels has the level of their geometric mean: stripes of one texel are seen below two, and
// grey from there on, whichever side is the longer one.
TEST(Texture, images_longer_than_high_are_filtered_over_a_square_of_the_same_area) {
    for (const bool wide : {true, false}) {
        const std::uint32_t columns = wide ? 128 : 32, rows = wide ? 32 : 128;
        std::vector<float> grey;
        for (std::uint32_t i = 0; i < columns * rows; ++i) {
            grey.push_back((wide ? i % columns : i / columns) % 2 == 0 ? 0.5F : 1.5F);
        }
        const Pixels pixels(columns, rows, grey);
        const Vec2 uv = wide ? Vec2(0.5F / 128, 0.5F) : Vec2(0.5F, 0.5F / 128);
        const float texel = 1 / 64.0F;  // of the square of the same area
        EXPECT_NEAR(grey_at(pixels.source, uv, 0.99F * texel), 0.5, 1e-3);
        EXPECT_NEAR(grey_at(pixels.source, uv, 1.5F * texel), 0.75, 1e-3);
        EXPECT_NEAR(grey_at(pixels.source, uv, 2 * texel), 1, 1e-3);
    }
}

TEST(Texture, one_texel_is_its_colour_everywhere) {
    const Pixels pixels(1, 1, {0.5F});
    for (const Vec2 uv : {Vec2(0, 0), Vec2(1, 1), Vec2(0.3F, -17.2F)}) {
        for (const float width : {0.0F, 0.5F, 9.0F}) {
            EXPECT_NEAR(grey_at(pixels.source, uv, width), 0.5, 0.002);
        }
    }
}

TEST(Texture, resolution_is_the_longer_side_of_what_is_stored) {
    const Pixels pixels(2, 4, std::vector<float>(8, 0.2F));
    Messages messages;
    EXPECT_EQ(make_set(pixels.source, messages).resolution(0), 4U);
    EXPECT_EQ(make_set(pixels.source, messages, 20).resolution(0), 2U);
}

TEST(Texture, byte_like_pixels_take_a_byte_each) {
    const Pixels bytes(4, 4, std::vector<float>(16, 51 / 255.0F));
    const Pixels floats(4, 4, std::vector<float>(16, 51.4F / 255.0F));
    Messages messages;
    EXPECT_EQ(make_set(bytes.source, messages).memory_bytes(), 3U * (16 + 4 + 1));
    EXPECT_EQ(make_set(floats.source, messages).memory_bytes(), 6U * (16 + 4 + 1));
    EXPECT_FLOAT_EQ(grey_at(bytes.source, {0.4F, 0.4F}), 0.2F);
}

TEST(Texture, texture_coordinates_that_are_not_finite_are_black) {
    const Pixels pixels(2, 1, {1.5F, 0.25F});
    EXPECT_EQ(grey_at(pixels.source, {std::numeric_limits<float>::quiet_NaN(), 0}), 0);
    EXPECT_EQ(grey_at(pixels.source, {0, std::numeric_limits<float>::infinity()}), 0);
    // A width that is not finite is the finest level.
    EXPECT_EQ(grey_at(pixels.source, {0.25F, 0}, std::numeric_limits<float>::quiet_NaN()), 1.5F);
}

void expect_magenta_with_message(const ImageSource& source) {
    Messages messages;
    const TextureSet set = make_set(source, messages);
    EXPECT_EQ(set.lookup(0, {0.3F, 0.6F}, 0), Rgb(1, 0, 1));
    EXPECT_EQ(set.lookup(0, {0.3F, 0.6F}, 2), Rgb(1, 0, 1));
    const std::vector<Message> all = messages.all();
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].object, source.name);
    EXPECT_NE(all[0].text.find("cannot be read"), std::string::npos);
}

TEST(Texture, a_missing_file_is_magenta_with_a_message) {
    ImageSource source;
    source.name = "missing";
    source.path = TempFile(".png").path();
    expect_magenta_with_message(source);
}

TEST(Texture, garbage_and_cut_files_are_magenta_with_a_message) {
    const TempFile garbage(".jpg"), cut(".ppm");
    garbage.write(std::string(1000, '\x7f'));
    cut.write(test::pixmap(50, 50, 3, 255, {1, 2, 3, 4}));
    for (const TempFile* file : {&garbage, &cut}) {
        ImageSource source;
        source.name = "broken";
        source.path = file->path();
        expect_magenta_with_message(source);
    }
}

TEST(Texture, pixels_that_do_not_fit_their_size_are_magenta_with_a_message) {
    Pixels pixels(2, 2, {1, 1, 1});
    expect_magenta_with_message(pixels.source);
    pixels.source.pixels = {};
    pixels.source.width = 0;
    expect_magenta_with_message(pixels.source);
}

TEST(Texture, memory_limit_halves_the_largest_and_says_so) {
    const Pixels large(64, 64, std::vector<float>(64 * 64, 0.2F)), small(8, 8, std::vector<float>(64, 0.4F));
    const ImageSource sources[] = {large.source, small.source};
    Messages messages;
    const std::size_t limit = 3000;
    const TextureSet set(sources, Control{}, messages, limit);
    EXPECT_LE(set.memory_bytes(), limit);
    const std::vector<Message> all = messages.all();
    ASSERT_EQ(all.size(), 1U);
    EXPECT_NE(all[0].text.find("lower resolution"), std::string::npos);
    EXPECT_NEAR(set.lookup(0, {0.5F, 0.5F}, 0).g, 0.2, 0.001);
    EXPECT_NEAR(set.lookup(1, {0.5F, 0.5F}, 0).g, 0.4, 0.001);
    EXPECT_GT(TextureSet(sources, Control{}, messages, 0).memory_bytes(), 0U);  // one texel each is the least
}

TEST(Texture, many_threads_read_the_same_values) {
    const TempFile file(".ppm");
    std::vector<int> values;
    for (std::uint64_t index = 0; index < 3 * 128 * 128; ++index) {
        values.push_back(static_cast<int>(hash64(index) >> 56));
    }
    file.write(test::pixmap(128, 128, 3, 255, values));
    ImageSource source;
    source.path = file.path();
    Messages messages;
    const TextureSet set = make_set(source, messages);
    const auto read = [&](int threads) {
        std::vector<Rgb> colors(20000);
        run_with_threads(threads, [&] {
            parallel_for(colors.size(), 16, Control{}, [&](std::size_t index) {
                const Sequence4 sequence(index);
                colors[index] = set.lookup(0, {sequence(0, 0), sequence(0, 1)}, 0.1F * sequence(0, 2));
            });
        });
        return colors;
    };
    const std::vector<Rgb> alone = read(1);
    EXPECT_EQ(read(2), alone);
    EXPECT_EQ(read(7), alone);
}

TEST(Texture, loading_stops_when_cancelled) {
    const Pixels pixels(1, 1, {0.5F});
    Control control;
    control.cancel();
    Messages messages;
    EXPECT_THROW(TextureSet(std::span(&pixels.source, 1), control, messages), Cancelled);
}

}  // namespace
}  // namespace gg
