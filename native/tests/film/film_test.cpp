#include "film/film.h"

#include <gtest/gtest.h>

namespace gg {
namespace {

TEST(film, tiles_cover_every_pixel_once) {
    const Film film(70, 33);
    EXPECT_EQ(film.tile_count(), 6U);
    std::vector<int> covered(70 * 33, 0);
    for (std::uint32_t index = 0; index < film.tile_count(); ++index) {
        const Rectangle tile = film.tile(index);
        for (std::uint32_t y = tile.y; y < tile.y + tile.height; ++y) {
            for (std::uint32_t x = tile.x; x < tile.x + tile.width; ++x) {
                ++covered[y * 70 + x];
            }
        }
    }
    EXPECT_EQ(covered, std::vector<int>(70 * 33, 1));
}

TEST(film, reads_what_was_finished_and_zero_elsewhere) {
    Film film(40, 34);
    std::vector<Rgba> tile(8 * 2);
    for (std::size_t index = 0; index < tile.size(); ++index) {
        tile[index] = {Rgb(static_cast<float>(index)), 1};
    }
    film.finish_tile(3, tile);
    std::vector<Rgba> pixels(3 * 3);
    film.read({31, 31, 3, 3}, pixels);
    EXPECT_EQ(pixels[0].alpha, 0);
    EXPECT_EQ(pixels[4].color.r, 0);
    EXPECT_EQ(pixels[4].alpha, 1);
    EXPECT_EQ(pixels[5].color.r, 1);
    EXPECT_EQ(pixels[8].color.r, 9);
}

TEST(film, finished_tiles_come_in_order_once) {
    Film film(64, 32);
    const std::vector<Rgba> tile(32 * 32);
    EXPECT_FALSE(film.next_finished_tile());
    film.finish_tile(1, tile);
    film.finish_tile(0, tile);
    EXPECT_EQ(film.finished_tiles(), 2U);
    EXPECT_EQ(film.next_finished_tile()->x, 32U);
    EXPECT_EQ(film.next_finished_tile()->x, 0U);
    EXPECT_FALSE(film.next_finished_tile());
}

TEST(film, contains_only_rectangles_within) {
    const Film film(40, 34);
    EXPECT_TRUE(film.contains({0, 0, 40, 34}));
    EXPECT_TRUE(film.contains({39, 33, 1, 1}));
    EXPECT_FALSE(film.contains({39, 33, 2, 1}));
    EXPECT_FALSE(film.contains({0, 0, 0, 1}));
    EXPECT_FALSE(film.contains({40, 0, 1, 1}));
    EXPECT_FALSE(film.contains({1, 1, 0xFFFFFFFFU, 1}));
}

}  // namespace
}  // namespace gg
