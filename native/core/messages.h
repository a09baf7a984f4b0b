// The one list of recoverable problems: what was skipped or approximated, for which object, how often.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace gg {

struct Message {
    std::string object;
    std::string text;
    std::uint32_t count = 1;
};

// Thread-safe. Equal (object, text) pairs are counted, not repeated; they stand in the order in which they came.
class Messages {
  public:
    void add(const std::string& object, const std::string& text, std::uint32_t count = 1);
    [[nodiscard]] std::vector<Message> all() const;

  private:
    mutable std::mutex mutex_;
    std::vector<Message> messages_;
    std::map<std::pair<std::string, std::string>, std::size_t> places_;  // in messages_, of (object, text)
};

}  // namespace gg
