#include "core/messages.h"

namespace gg {

void Messages::add(const std::string& object, const std::string& text, std::uint32_t count) {
    const std::lock_guard lock(mutex_);
    const auto [place, is_new] = places_.try_emplace({object, text}, messages_.size());
    if (is_new) {
        messages_.push_back({object, text, count});
    } else {
        messages_[place->second].count += count;
    }
}

std::vector<Message> Messages::all() const {
    const std::lock_guard lock(mutex_);
    return messages_;
}

}  // namespace gg
