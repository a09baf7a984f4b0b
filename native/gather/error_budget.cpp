#include "gather/error_budget.h"

#include <algorithm>
#include <numeric>

namespace gg {

std::vector<std::size_t> beyond_budget(std::span<const float> errors, float tolerance) {
    constexpr float kSum = 6, kRoot = 2;
    double sum = 0, squares = 0;
    for (const float error : errors) {
        sum += error;
        squares += static_cast<double>(error) * error;
    }
    std::vector<std::size_t> order(errors.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return errors[a] > errors[b]; });
    const double most = kSum * tolerance, most_squares = static_cast<double>(kRoot * tolerance) * (kRoot * tolerance);
    std::size_t count = 0;
    while (count < order.size() && errors[order[count]] > 0 && (sum > most || squares > most_squares)) {
        const float error = errors[order[count++]];
        sum -= error;
        squares -= static_cast<double>(error) * error;
    }
    order.resize(count);
    return order;
}

}  // namespace gg
