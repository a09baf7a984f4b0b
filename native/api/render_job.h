// One render on a thread of its own, and what the caller may ask about it meanwhile.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "api/guard.h"
#include "core/control.h"
#include "core/messages.h"
#include "core/statistics.h"
#include "film/film.h"
#include "render/pipeline.h"

namespace gg {

struct SceneCache;

class RenderJob {
  public:
    // Starts at once. The cache has to outlive the job.
    RenderJob(SceneCache& cache, const RenderSettings& settings, const std::vector<Message>& messages);
    // Cancels and waits.
    ~RenderJob();
    RenderJob(const RenderJob&) = delete;
    RenderJob& operator=(const RenderJob&) = delete;

    void cancel() { control_.cancel(); }
    // True when it has finished within that time.
    bool wait(std::chrono::duration<double> timeout);
    [[nodiscard]] bool finished() const { return finished_.load(std::memory_order_acquire); }
    // Once finished: how it ended.
    [[nodiscard]] const Failure& outcome() const { return outcome_; }

    [[nodiscard]] gg_progress progress();
    [[nodiscard]] Film& film() { return film_; }
    [[nodiscard]] const Messages& messages() const { return messages_; }
    [[nodiscard]] const Statistics& statistics() const { return statistics_; }

  private:
    void run(SceneCache& cache, const RenderSettings& settings);

    Film film_;
    Control control_;
    Messages messages_;
    Statistics statistics_;
    Failure outcome_{GG_OK, {}};
    std::atomic<bool> finished_{false};
    std::atomic<std::uint64_t> peak_memory_{0};
    std::mutex mutex_;
    std::condition_variable finish_;
    std::thread thread_;  // last: it uses all the others
};

}  // namespace gg
