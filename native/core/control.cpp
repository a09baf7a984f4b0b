#include "core/control.h"

#include <algorithm>

namespace gg {

void Control::begin_stage(const std::string& name, float fraction_end) {
    check_cancel();
    const std::lock_guard lock(mutex_);
    stage_ = name;
    stage_begin_ = stage_end_;
    stage_end_ = fraction_end;
    stage_progress_.store(0);
}

std::string Control::stage() const {
    const std::lock_guard lock(mutex_);
    return stage_;
}

float Control::fraction() const {
    const std::lock_guard lock(mutex_);
    return stage_begin_ + (stage_end_ - stage_begin_) * std::clamp(stage_progress_.load(), 0.0F, 1.0F);
}

}  // namespace gg
