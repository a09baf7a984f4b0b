#include "core/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "core/control.h"

namespace gg {

int thread_count() {
    return tbb::this_task_arena::max_concurrency();
}

void run_with_threads(int threads, const std::function<void()>& work) {
    tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
    arena.execute(work);
}

void parallel_blocks(std::size_t count, std::size_t block, const Control& control,
                     const std::function<void(std::size_t, std::size_t)>& body) {
    const std::size_t blocks = (count + block - 1) / block;
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, blocks, 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
            for (std::size_t index = range.begin(); index < range.end(); ++index) {
                if (control.cancelled()) {
                    return;
                }
                body(index * block, std::min(count, (index + 1) * block));
            }
        },
        tbb::simple_partitioner{});
    control.check_cancel();
}

}  // namespace gg
