// Several ascending lists, walked along together.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "scene/description.h"

namespace gg {

// Calls body(key) for every key of several ascending lists, in ascending order. heads: the keys at which the lists
// stand, kNone at an end; body has to move on those that are its key.
template <typename Body>
void merge(std::span<const std::uint32_t> heads, const Body& body) {
    for (;;) {
        std::uint32_t least = kNone;
        for (const std::uint32_t head : heads) {
            least = std::min(least, head);
        }
        if (least == kNone) {
            return;
        }
        body(least);
    }
}

}  // namespace gg
