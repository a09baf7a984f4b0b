#include "core/messages.h"

#include <algorithm>

namespace gg {

void Messages::add(const std::string& object, const std::string& text, std::uint32_t count) {
    const std::lock_guard lock(mutex_);
    const auto same = std::find_if(messages_.begin(), messages_.end(),
                                   [&](const Message& m) { return m.object == object && m.text == text; });
    if (same != messages_.end()) {
        same->count += count;
    } else {
        messages_.push_back({object, text, count});
    }
}

std::vector<Message> Messages::all() const {
    const std::lock_guard lock(mutex_);
    return messages_;
}

}  // namespace gg
