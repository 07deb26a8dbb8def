#pragma once

#include "common/interrupt.hpp"
#include "common/terminal.hpp"

#include <isostretch/core/monitor.hpp>

#include <string>

namespace isostretch::app {

/// Returns what shows progress on the terminal, and ends with Ctrl-C.
inline Monitor terminal_monitor() {
  return {interrupt_token(), [](const std::string& line) { show_progress(line); }};
}

}  // namespace isostretch::app
