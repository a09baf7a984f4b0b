// The one exception of the library: what the environment or the caller did wrong, as a status code of the C interface.
#pragma once

#include <stdexcept>
#include <string>

#include "gridgather.h"

namespace gg {

class Error : public std::runtime_error {
  public:
    Error(gg_status status, const std::string& message) : std::runtime_error(message), status_(status) {}
    [[nodiscard]] gg_status status() const { return status_; }

  private:
    gg_status status_;
};

}  // namespace gg
