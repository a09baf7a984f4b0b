// Times by stage, counts and bytes, as a JSON object in the order in which they were first written.
#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace gg {

// Thread-safe.
class Statistics {
  public:
    void add_seconds(const std::string& stage, double seconds) { add(stages_, stage, seconds); }
    void set_count(const std::string& name, double value) { set(counts_, name, value); }
    void set_bytes(const std::string& name, double bytes) { set(memory_, name, bytes); }
    [[nodiscard]] double total_bytes() const;
    [[nodiscard]] std::string json() const;
    void merge(const Statistics& other);

  private:
    using Table = std::vector<std::pair<std::string, double>>;
    void add(Table& table, const std::string& name, double value);
    void set(Table& table, const std::string& name, double value);

    mutable std::mutex mutex_;
    Table stages_, counts_, memory_;
};

// Adds the time of its life to a stage.
class StageTimer {
  public:
    StageTimer(Statistics& statistics, std::string stage) : statistics_(statistics), stage_(std::move(stage)) {}
    ~StageTimer() {
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
        statistics_.add_seconds(stage_, spent.count());
    }
    StageTimer(const StageTimer&) = delete;
    StageTimer& operator=(const StageTimer&) = delete;

  private:
    Statistics& statistics_;
    std::string stage_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace gg
