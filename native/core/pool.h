// Workers with memory of their own that many blocks of a parallel loop use, one after the other: as many as threads are
// at work at the same time.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace gg {

template <typename T>
class Pool {
  public:
    // make: a new worker, called by any thread.
    explicit Pool(std::function<std::unique_ptr<T>()> make) : make_(std::move(make)) {}

    // Calls work(worker) with one that nobody else uses meanwhile. A worker whose work throws is lost.
    template <typename Work>
    void use(const Work& work) {
        std::unique_ptr<T> worker = take();
        work(*worker);
        const std::scoped_lock lock(mutex_);
        idle_.push_back(std::move(worker));
    }

    // All workers, when none is in use.
    [[nodiscard]] const std::vector<std::unique_ptr<T>>& all() const { return idle_; }

  private:
    std::unique_ptr<T> take() {
        {
            const std::scoped_lock lock(mutex_);
            if (!idle_.empty()) {
                std::unique_ptr<T> worker = std::move(idle_.back());
                idle_.pop_back();
                return worker;
            }
        }
        return make_();
    }

    std::function<std::unique_ptr<T>()> make_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<T>> idle_;
};

}  // namespace gg
