#include "core/messages.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "core/control.h"
#include "core/parallel.h"

namespace gg {
namespace {

TEST(Messages, equal_object_and_text_are_counted_not_repeated) {
    Messages messages;
    messages.add("Cube", "Broken");
    messages.add("Cube", "Broken", 3);
    messages.add("Cube", "Missing");
    messages.add("Lamp", "Broken");
    const std::vector<Message> all = messages.all();
    ASSERT_EQ(all.size(), 3U);
    EXPECT_EQ(all[0].object, "Cube");
    EXPECT_EQ(all[0].text, "Broken");
    EXPECT_EQ(all[0].count, 4U);
    EXPECT_EQ(all[1].text, "Missing");
    EXPECT_EQ(all[2].object, "Lamp");
    EXPECT_EQ(all[2].count, 1U);
}

// A scene of broken meshes only.
TEST(Messages, a_hundred_thousand_objects_take_no_time) {
    constexpr std::size_t kObjects = 100000;
    Messages messages;
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < kObjects; ++i) {
        messages.add("Cube." + std::to_string(i), "Broken");
    }
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
    const std::vector<Message> all = messages.all();
    ASSERT_EQ(all.size(), kObjects);
    EXPECT_EQ(all.back().object, "Cube.99999");
}

TEST(Messages, none_is_lost_between_threads) {
    Messages messages;
    run_with_threads(7, [&] {
        parallel_for(200000, 100, Control{}, [&](std::size_t index) { messages.add("x", index % 2 ? "odd" : "even"); });
    });
    const std::vector<Message> all = messages.all();
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[0].count, 100000U);
    EXPECT_EQ(all[1].count, 100000U);
}

}  // namespace
}  // namespace gg
