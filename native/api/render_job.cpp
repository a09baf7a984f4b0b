#include "api/render_job.h"

#include <algorithm>
#include <cstdio>

namespace gg {

RenderJob::RenderJob(SceneCache& cache, const RenderSettings& settings, const std::vector<Message>& messages)
    : film_(settings.view.crop.width, settings.view.crop.height, settings.passes) {
    for (const Message& message : messages) {
        messages_.add(message.object, message.text, message.count);
    }
    thread_ = std::thread([this, &cache, settings] { run(cache, settings); });
}

RenderJob::~RenderJob() {
    cancel();
    thread_.join();
}

void RenderJob::run(SceneCache& cache, const RenderSettings& settings) {
    try {
        render(cache, settings, film_, control_, messages_, statistics_);
    } catch (...) {
        outcome_ = current_failure();
    }
    const std::lock_guard lock(mutex_);
    finished_.store(true, std::memory_order_release);
    finish_.notify_all();
}

bool RenderJob::wait(std::chrono::duration<double> timeout) {
    std::unique_lock lock(mutex_);
    return finish_.wait_for(lock, timeout, [this] { return finished(); });
}

gg_progress RenderJob::progress() {
    gg_progress result{};
    result.finished = finished() ? 1 : 0;
    result.status = result.finished ? outcome_.status : GG_OK;
    result.fraction = result.finished && result.status == GG_OK ? 1.0F : control_.fraction();
    result.finished_tiles = film_.finished_tiles();
    result.tiles = film_.tile_count();
    result.memory = static_cast<std::uint64_t>(statistics_.total_bytes());
    std::uint64_t peak = peak_memory_.load();
    while (peak < result.memory && !peak_memory_.compare_exchange_weak(peak, result.memory)) {
    }
    result.peak_memory = std::max(peak, result.memory);
    std::snprintf(result.stage, sizeof(result.stage), "%s", control_.stage().c_str());
    return result;
}

}  // namespace gg
