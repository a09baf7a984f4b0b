#include "core/statistics.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace gg {

namespace {

double& entry(std::vector<std::pair<std::string, double>>& table, const std::string& name) {
    const auto found = std::find_if(table.begin(), table.end(), [&](const auto& item) { return item.first == name; });
    return found != table.end() ? found->second : table.emplace_back(name, 0.0).second;
}

std::string json_table(const std::vector<std::pair<std::string, double>>& table, const char* format) {
    std::string text = "{";
    for (const auto& [name, value] : table) {
        char number[64];
        if (std::isfinite(value)) {
            std::snprintf(number, sizeof(number), format, value);
        } else {
            std::snprintf(number, sizeof(number), "null");
        }
        text += (text.size() > 1 ? ", \"" : "\"") + name + "\": " + number;
    }
    return text + "}";
}

}  // namespace

void Statistics::add(Table& table, const std::string& name, double value) {
    const std::lock_guard lock(mutex_);
    entry(table, name) += value;
}

void Statistics::set(Table& table, const std::string& name, double value) {
    const std::lock_guard lock(mutex_);
    entry(table, name) = value;
}

double Statistics::total_bytes() const {
    const std::lock_guard lock(mutex_);
    double total = 0;
    for (const auto& item : memory_) {
        total += item.second;
    }
    return total;
}

std::string Statistics::json() const {
    const std::lock_guard lock(mutex_);
    return "{\"stages\": " + json_table(stages_, "%.4f") + ", \"counts\": " + json_table(counts_, "%.10g") +
           ", \"memory\": " + json_table(memory_, "%.0f") + "}";
}

void Statistics::merge(const Statistics& other) {
    for (const auto& [name, value] : other.stages_) {
        add_seconds(name, value);
    }
    for (const auto& [name, value] : other.counts_) {
        set_count(name, value);
    }
    for (const auto& [name, value] : other.memory_) {
        set_bytes(name, value);
    }
}

}  // namespace gg
