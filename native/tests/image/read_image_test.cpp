#include "image/read_image.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "support/image_files.h"

namespace gg {
namespace {

using test::pixmap;
using test::TempFile;

TEST(ReadImage, bytes_come_unchanged_with_the_bottom_row_first) {
    const TempFile file(".ppm");
    file.write(pixmap(2, 2, 3, 255, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
    const RawImage image = read_image(file.path());
    EXPECT_EQ(image.header.width, 2U);
    EXPECT_EQ(image.header.height, 2U);
    EXPECT_TRUE(image.header.bytes);
    EXPECT_TRUE(image.floats.empty());
    EXPECT_EQ(image.bytes, (std::vector<std::uint8_t>{7, 8, 9, 10, 11, 12, 1, 2, 3, 4, 5, 6}));
    const ImageHeader header = read_image_header(file.path());
    EXPECT_EQ(header.width, 2U);
    EXPECT_TRUE(header.bytes);
}

TEST(ReadImage, grey_becomes_three_equal_channels) {
    const TempFile file(".pgm");
    file.write(pixmap(2, 1, 1, 255, {7, 200}));
    EXPECT_EQ(read_image(file.path()).bytes, (std::vector<std::uint8_t>{7, 7, 7, 200, 200, 200}));
}

TEST(ReadImage, sixteen_bits_become_floats) {
    const TempFile file(".ppm");
    file.write(pixmap(1, 1, 3, 65535, {0, 13107, 65535}));
    const RawImage image = read_image(file.path());
    EXPECT_FALSE(image.header.bytes);
    ASSERT_EQ(image.floats.size(), 3U);
    EXPECT_NEAR(image.floats[1], 0.2F, 1e-4);
    EXPECT_NEAR(image.floats[2], 1, 1e-4);
}

TEST(ReadImage, floats_keep_values_above_one) {
    const TempFile file(".hdr");
    file.write(test::radiance_picture(1, 2, {{12, 3, 0.5F}, {1, 1, 1}}));
    EXPECT_EQ(read_image(file.path()).floats, (std::vector<float>{1, 1, 1, 12, 3, 0.5F}));
}

TEST(ReadImage, missing_unknown_and_damaged_files_are_errors_with_a_sentence) {
    const TempFile missing(".png"), garbage(".png"), cut(".ppm"), huge(".ppm");
    garbage.write("this is no image at all");
    cut.write(pixmap(100, 100, 3, 255, {1, 2, 3}));
    huge.write("P6\n2000000000 2000000000\n255\n");
    for (const TempFile* file : {&missing, &garbage, &cut, &huge}) {
        try {
            (void)read_image(file->path());
            ADD_FAILURE() << "read " << file->path();
        } catch (const Error& error) {
            EXPECT_STRNE(error.what(), "");
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        }
    }
}

}  // namespace
}  // namespace gg
