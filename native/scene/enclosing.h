// Which boxes have another one inside.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"

namespace gg {

class Control;

// For each of the first `queried` boxes, 1 when any other box (of all) lies within it as a whole, borders included,
// else 0. Equal boxes enclose each other. No box may be empty. About n log n.
[[nodiscard]] std::vector<std::uint8_t> find_enclosing(std::span<const Box> boxes, std::size_t queried,
                                                       const Control& control);

}  // namespace gg
