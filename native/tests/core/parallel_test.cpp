#include "core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstring>
#include <functional>
#include <numeric>
#include <stdexcept>

#include "core/control.h"
#include "core/random.h"

namespace gg {
namespace {

// Terms of so different sizes that any other order of summation gives another float.
float term(std::size_t index) {
    return std::exp2(40 * unit_float(hash64(index)) - 20);
}

float sum_with(int threads) {
    float total = 0;
    run_with_threads(threads, [&] {
        total = ordered_reduce<float>(
            100001, 97, Control{}, 0.0F,
            [](std::size_t begin, std::size_t end) {
                float part = 0;
                for (std::size_t index = begin; index < end; ++index) {
                    part += term(index);
                }
                return part;
            },
            [](float a, float b) { return a + b; });
    });
    return total;
}

TEST(Parallel, ordered_reduce_gives_the_same_bytes_for_1_2_and_7_threads) {
    const float one = sum_with(1);
    for (const int threads : {2, 7}) {
        for (int run = 0; run < 5; ++run) {
            const float other = sum_with(threads);
            EXPECT_EQ(std::memcmp(&one, &other, sizeof(float)), 0);
        }
    }
}

TEST(Parallel, ordered_reduce_adds_every_term_once) {
    const auto sum = ordered_reduce<std::size_t>(
        1001, 10, Control{}, 0,
        [](std::size_t begin, std::size_t end) {
            std::size_t part = 0;
            for (std::size_t index = begin; index < end; ++index) {
                part += index;
            }
            return part;
        },
        std::plus<>());
    EXPECT_EQ(sum, 1000U * 1001U / 2);
}

TEST(Parallel, ordered_reduce_of_nothing_is_the_initial_value) {
    const int result = ordered_reduce<int>(
        0, 8, Control{}, 42, [](std::size_t, std::size_t) { return 1; }, [](int a, int b) { return a + b; });
    EXPECT_EQ(result, 42);
}

TEST(Parallel, every_index_is_visited_exactly_once) {
    for (const std::size_t count : {0, 1, 99, 100, 101}) {
        std::vector<int> visits(count, 0);
        parallel_for(count, 10, Control{}, [&](std::size_t index) { ++visits[index]; });
        EXPECT_EQ(visits, std::vector<int>(count, 1));
    }
}

TEST(Parallel, blocks_start_at_multiples_of_their_size) {
    std::vector<std::size_t> ends(3, 0);
    parallel_blocks(25, 10, Control{}, [&](std::size_t begin, std::size_t end) {
        EXPECT_EQ(begin % 10, 0U);
        ends[begin / 10] = end;
    });
    EXPECT_EQ(ends, (std::vector<std::size_t>{10, 20, 25}));
}

TEST(Parallel, collect_keeps_the_order_of_the_items) {
    std::vector<int> found;
    run_with_threads(7, [&] {
        found =
            parallel_collect<int>(10000, 7, Control{}, [](std::size_t begin, std::size_t end, std::vector<int>& out) {
                for (std::size_t index = begin; index < end; ++index) {
                    if (index % 3 == 0) {
                        out.push_back(static_cast<int>(index));
                    }
                }
            });
    });
    ASSERT_EQ(found.size(), 3334U);
    for (std::size_t index = 0; index < found.size(); ++index) {
        EXPECT_EQ(found[index], static_cast<int>(3 * index));
    }
}

TEST(Parallel, cancel_ends_a_loop_with_an_exception_and_skips_the_rest) {
    Control control;
    std::atomic<int> visited{0};
    EXPECT_THROW(parallel_for(1000000, 1, control,
                              [&](std::size_t) {
                                  if (++visited == 10) {
                                      control.cancel();
                                  }
                              }),
                 Cancelled);
    EXPECT_LT(visited, 1000);
}

TEST(Parallel, exceptions_reach_the_caller) {
    EXPECT_THROW(parallel_for(1000, 1, Control{},
                              [](std::size_t index) {
                                  if (index == 500) {
                                      throw std::runtime_error("broken");
                                  }
                              }),
                 std::runtime_error);
}

}  // namespace
}  // namespace gg
