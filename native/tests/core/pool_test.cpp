#include "core/pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

#include "core/control.h"
#include "core/parallel.h"

namespace gg {
namespace {

struct Counter {
    int uses = 0;
    int users = 0;  // at the moment
};

TEST(Pool, a_worker_is_used_again_and_by_one_at_a_time) {
    Control control;
    std::atomic<int> made{0}, shared{0};
    Pool<Counter> pool([&] {
        ++made;
        return std::make_unique<Counter>();
    });
    for (int i = 0; i < 3; ++i) {
        pool.use([](Counter& counter) { ++counter.uses; });
    }
    EXPECT_EQ(made, 1);
    parallel_for(1000, 1, control, [&](std::size_t) {
        pool.use([&](Counter& counter) {
            shared += ++counter.users > 1 ? 1 : 0;
            ++counter.uses;
            --counter.users;
        });
    });
    EXPECT_EQ(shared, 0);
    int uses = 0;
    for (const auto& counter : pool.all()) {
        uses += counter->uses;
    }
    EXPECT_EQ(uses, 1003);
    EXPECT_EQ(pool.all().size(), static_cast<std::size_t>(made));
}

TEST(Pool, a_worker_whose_work_fails_is_not_used_again) {
    int made = 0;
    Pool<Counter> pool([&] {
        ++made;
        return std::make_unique<Counter>();
    });
    EXPECT_THROW(pool.use([](Counter&) { throw std::runtime_error("no"); }), std::runtime_error);
    EXPECT_TRUE(pool.all().empty());
    pool.use([](Counter& counter) { EXPECT_EQ(counter.uses, 0); });
    EXPECT_EQ(made, 2);
}

}  // namespace
}  // namespace gg
