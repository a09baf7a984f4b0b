// Progress and cancellation of one running job, shared by the working threads and the caller who watches.
#pragma once

#include <atomic>
#include <mutex>
#include <string>

namespace gg {

struct Cancelled {};  // thrown by check_cancel(), caught where the job started

class Control {
  public:
    void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
    [[nodiscard]] bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }
    void check_cancel() const {
        if (cancelled()) {
            throw Cancelled{};
        }
    }

    // Begins a stage that ends at `fraction_end` of the whole job (0..1).
    void begin_stage(const std::string& name, float fraction_end);
    // Share of the current stage that is done, 0..1.
    void set_stage_progress(float fraction) { stage_progress_.store(fraction, std::memory_order_relaxed); }

    [[nodiscard]] std::string stage() const;
    [[nodiscard]] float fraction() const;

  private:
    std::atomic<bool> cancelled_{false};
    std::atomic<float> stage_progress_{0};
    mutable std::mutex mutex_;
    std::string stage_;
    float stage_begin_ = 0;
    float stage_end_ = 0;
};

}  // namespace gg
