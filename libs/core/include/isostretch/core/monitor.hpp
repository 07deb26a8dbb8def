#pragma once

#include <isostretch/core/stop_token.hpp>

#include <functional>
#include <string>

namespace isostretch {

/// How a caller follows a long computation and ends it.
struct Monitor {
  StopToken stop;
  /// Gets a line to be shown in the place of the one before, often; may be empty.
  std::function<void(const std::string& line)> progress;

  /// Returns a monitor that ends the computation so many seconds from now as well; 0 or less sets no limit.
  Monitor with_time_limit(double seconds) const { return {stop.with_time_limit(seconds), progress}; }

  void show(const std::string& line) const {
    if (progress) progress(line);
  }
};

}  // namespace isostretch
