// Exceptions become error codes here and nowhere else.
#pragma once

#include <string>

#include "core/control.h"
#include "core/error.h"
#include "gridgather.h"

namespace gg {

// What gg_last_error of this thread returns from now on.
void set_last_error(const std::string& text) noexcept;

// Status and sentence of the exception that is being handled.
struct Failure {
    gg_status status = GG_INTERNAL_ERROR;
    std::string text;
};
[[nodiscard]] Failure current_failure() noexcept;

// Runs the body of a function of the interface.
template <typename Body>
gg_status guarded(const Body& body) noexcept {
    try {
        body();
        return GG_OK;
    } catch (...) {
        const Failure failure = current_failure();
        set_last_error(failure.text);
        return failure.status;
    }
}

// Throws Error(GG_INVALID_ARGUMENT) unless `condition`.
inline void require(bool condition, const char* text) {
    if (!condition) {
        throw Error(GG_INVALID_ARGUMENT, text);
    }
}

}  // namespace gg
