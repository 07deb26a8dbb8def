#pragma once

#include <isostretch/core/stop_token.hpp>

#include <functional>
#include <string>

namespace isostretch {

/// The means by which a caller follows a long computation and ends it.
struct Monitor {
  /// Ends the computation, on request or at a deadline.
  StopToken stop;
  /// A function that is often called with a line to show in place of the line before; may be empty.
  std::function<void(const std::string& line)> progress;

  /// Returns a monitor that also ends the computation `seconds` from now; 0 or less sets no limit.
  Monitor with_time_limit(double seconds) const { return {stop.with_time_limit(seconds), progress}; }

  /// Calls `progress` with the line, if there is such a function.
  void show(const std::string& line) const {
    if (progress) progress(line);
  }
};

}  // namespace isostretch
