#include "api/guard.h"

#include <exception>
#include <new>

namespace gg {

namespace {

thread_local std::string last_error;

}  // namespace

void set_last_error(const std::string& text) noexcept {
    try {
        last_error = text;
    } catch (...) {
        last_error.clear();  // no memory for a sentence
    }
}

Failure current_failure() noexcept {
    try {
        try {
            throw;
        } catch (const Cancelled&) {
            return {GG_CANCELLED, "cancelled"};
        } catch (const Error& error) {
            return {error.status(), error.what()};
        } catch (const std::bad_alloc&) {
            return {GG_OUT_OF_MEMORY, "out of memory"};
        } catch (const std::exception& error) {
            return {GG_INTERNAL_ERROR, std::string("internal error: ") + error.what()};
        } catch (...) {
            return {GG_INTERNAL_ERROR, "internal error"};
        }
    } catch (...) {
        return {GG_OUT_OF_MEMORY, {}};  // no memory for the sentence
    }
}

}  // namespace gg

const char* gg_last_error(void) {
    return gg::last_error.c_str();
}
