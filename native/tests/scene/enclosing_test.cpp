#include "scene/enclosing.h"

#include <gtest/gtest.h>

#include "core/control.h"
#include "core/random.h"

namespace gg {
namespace {

TEST(Enclosing, only_boxes_that_hold_another_as_a_whole) {
    const Box room{Vec3(0), Vec3(10)};
    const Box chair{Vec3(1), Vec3(2)};
    const Box door{Vec3(9, 1, 1), Vec3(11, 2, 2)};  // sticks out
    const Box lamp{Vec3(20), Vec3(20)};             // a point, outside
    EXPECT_EQ(find_enclosing(std::vector{room, chair, door, lamp}, 4, Control{}),
              (std::vector<std::uint8_t>{1, 0, 0, 0}));
    EXPECT_EQ(find_enclosing(std::vector{room, door, lamp}, 3, Control{}), (std::vector<std::uint8_t>{0, 0, 0}));
}

TEST(Enclosing, a_box_does_not_hold_itself_but_its_twin) {
    const Box box{Vec3(0), Vec3(1)};
    EXPECT_EQ(find_enclosing(std::vector{box}, 1, Control{}), (std::vector<std::uint8_t>{0}));
    EXPECT_EQ(find_enclosing(std::vector{box, box}, 2, Control{}), (std::vector<std::uint8_t>{1, 1}));
    EXPECT_TRUE(find_enclosing({}, 0, Control{}).empty());
}

TEST(Enclosing, boxes_beyond_the_queried_count_only_as_contents) {
    const Box room{Vec3(0), Vec3(10)};
    const Box lamp{Vec3(5), Vec3(5)};
    EXPECT_EQ(find_enclosing(std::vector{room, lamp}, 1, Control{}), (std::vector<std::uint8_t>{1}));
}

TEST(Enclosing, agrees_with_comparing_all_pairs) {
    std::vector<Box> boxes;
    for (std::uint64_t index = 0; index < 1500; ++index) {
        const Sequence4 place(index), size(index + 100000);
        const Vec3 lower = 10.0F * Vec3(place(0, 0), place(0, 1), place(0, 2));
        const float scale = index % 10 == 0 ? 3.0F : 0.3F;
        boxes.push_back({lower, lower + scale * Vec3(size(0, 0), size(0, 1), size(0, 2))});
    }
    const std::vector<std::uint8_t> found = find_enclosing(boxes, boxes.size(), Control{});
    int enclosing = 0;
    for (std::size_t outer = 0; outer < boxes.size(); ++outer) {
        bool holds = false;
        for (std::size_t inner = 0; inner < boxes.size(); ++inner) {
            holds |= inner != outer && boxes[outer].contains(boxes[inner]);
        }
        ASSERT_EQ(found[outer] != 0, holds) << outer;
        enclosing += holds ? 1 : 0;
    }
    EXPECT_GT(enclosing, 50);
    EXPECT_LT(enclosing, 1000);
}

}  // namespace
}  // namespace gg
