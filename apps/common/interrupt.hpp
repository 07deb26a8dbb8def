#pragma once

#include <isostretch/core/stop_token.hpp>

namespace isostretch::app {

// From here on the first Ctrl-C (or SIGTERM) is only noted, so that the app can finish its iteration and
// write what it has; the second one ends the program at once.
void catch_interrupts();

/// Returns the token that Ctrl-C asks to stop.
StopToken interrupt_token();
bool interrupted() noexcept;

}  // namespace isostretch::app
