// How many small errors may add up.
#pragma once

#include <span>
#include <vector>

namespace gg {

// Many errors that alone are not seen make one that is. Indices of the errors that have to go, largest first, until the
// sum of the others is at most 6 times the tolerance and the root of their squares' sum at most twice. errors: >= 0.
[[nodiscard]] std::vector<std::size_t> beyond_budget(std::span<const float> errors, float tolerance);

}  // namespace gg
