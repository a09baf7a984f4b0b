#include "scene/weld.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace gg {
namespace {

TEST(Weld, each_vertex_names_the_first_at_its_position) {
    const std::vector<Vec3> positions = {{1, 2, 3}, {0, 0, 0}, {1, 2, 3}, {-0.0F, 0, -0.0F}, {1, 2, 3.0000002F}};
    EXPECT_EQ(weld_positions(positions), (std::vector<std::uint32_t>{0, 1, 0, 1, 4}));
    EXPECT_TRUE(weld_positions({}).empty());
}

TEST(Weld, agrees_with_comparing_all_pairs) {
    std::vector<Vec3> positions;
    for (std::uint64_t index = 0; index < 2000; ++index) {
        const auto coordinate = [&](int axis) { return static_cast<float>(hash64(index, axis) % 8); };
        positions.emplace_back(coordinate(0), coordinate(1), coordinate(2));
    }
    const std::vector<std::uint32_t> welded = weld_positions(positions);
    for (std::uint32_t vertex = 0; vertex < positions.size(); ++vertex) {
        std::uint32_t first = 0;
        while (positions[first] != positions[vertex]) {
            ++first;
        }
        ASSERT_EQ(welded[vertex], first);
    }
}

}  // namespace
}  // namespace gg
