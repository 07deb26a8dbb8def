#pragma once

namespace isostretch::app {

// From here on the first Ctrl-C (or SIGTERM) is only noted, so that the app can finish its iteration and
// write what it has; the second one ends the program at once.
void catch_interrupts();
bool interrupted() noexcept;

}  // namespace isostretch::app
