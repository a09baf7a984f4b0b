#include "core/statistics.h"

#include <gtest/gtest.h>

namespace gg {
namespace {

TEST(Statistics, json_keeps_the_order_of_first_writing) {
    Statistics statistics;
    statistics.add_seconds("solve", 1.5);
    statistics.add_seconds("build", 0.25);
    statistics.add_seconds("solve", 0.5);
    statistics.set_count("links", 12);
    statistics.set_count("links", 1234567);
    statistics.set_bytes("tree", 4096);
    EXPECT_EQ(statistics.json(),
              "{\"stages\": {\"solve\": 2.0000, \"build\": 0.2500}, \"counts\": {\"links\": 1234567}, "
              "\"memory\": {\"tree\": 4096}}");
}

TEST(Statistics, json_of_nothing_has_the_three_tables) {
    EXPECT_EQ(Statistics{}.json(), "{\"stages\": {}, \"counts\": {}, \"memory\": {}}");
}

TEST(Statistics, merge_adds_times_and_takes_over_counts) {
    Statistics a, b;
    a.add_seconds("solve", 1);
    a.set_bytes("tree", 1);
    b.add_seconds("solve", 2);
    b.set_count("links", 5);
    b.set_bytes("tree", 10);
    a.merge(b);
    EXPECT_EQ(a.json(), "{\"stages\": {\"solve\": 3.0000}, \"counts\": {\"links\": 5}, \"memory\": {\"tree\": 10}}");
    EXPECT_EQ(a.total_bytes(), 10);
}

TEST(Statistics, timer_adds_the_time_of_its_life) {
    Statistics statistics;
    { const StageTimer timer(statistics, "wait"); }
    EXPECT_NE(statistics.json().find("\"wait\": 0.0"), std::string::npos);
}

}  // namespace
}  // namespace gg
