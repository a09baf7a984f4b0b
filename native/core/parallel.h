// Parallel loops. Every loop of the library goes through here, so that results never depend on the number of threads:
// blocks have a fixed size, every output has one writer, and reductions combine blocks in index order.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace gg {

class Control;

// Runs `work` with at most `threads` threads (0: all cores) in every loop that it starts.
void run_with_threads(int threads, const std::function<void()>& work);

// That loops which are started here may use.
[[nodiscard]] int thread_count();

// body(begin, end) for consecutive blocks of `block` items that cover [0, count). Throws Cancelled between blocks.
void parallel_blocks(std::size_t count, std::size_t block, const Control& control,
                     const std::function<void(std::size_t, std::size_t)>& body);

// body(index) for every index in [0, count).
template <typename Body>
void parallel_for(std::size_t count, std::size_t block, const Control& control, const Body& body) {
    parallel_blocks(count, block, control, [&](std::size_t begin, std::size_t end) {
        for (std::size_t index = begin; index < end; ++index) {
            body(index);
        }
    });
}

// map(begin, end) per block of fixed size, combined from first to last block: the same sum for any number of threads.
template <typename T, typename Map, typename Combine>
[[nodiscard]] T ordered_reduce(std::size_t count, std::size_t block, const Control& control, T initial, const Map& map,
                               const Combine& combine) {
    std::vector<T> parts((count + block - 1) / block, initial);
    parallel_blocks(count, block, control,
                    [&](std::size_t begin, std::size_t end) { parts[begin / block] = map(begin, end); });
    T total = std::move(initial);
    for (T& part : parts) {
        total = combine(std::move(total), std::move(part));
    }
    return total;
}

// Appends to one output list from many blocks; the order of the result is that of the items.
// body(begin, end, out) appends the block's results to `out`.
template <typename T, typename Body>
[[nodiscard]] std::vector<T> parallel_collect(std::size_t count, std::size_t block, const Control& control,
                                              const Body& body) {
    std::vector<std::vector<T>> parts((count + block - 1) / block);
    parallel_blocks(count, block, control,
                    [&](std::size_t begin, std::size_t end) { body(begin, end, parts[begin / block]); });
    std::size_t total = 0;
    for (const auto& part : parts) {
        total += part.size();
    }
    std::vector<T> result;
    result.reserve(total);
    for (auto& part : parts) {
        result.insert(result.end(), part.begin(), part.end());
        std::vector<T>().swap(part);
    }
    return result;
}

}  // namespace gg
