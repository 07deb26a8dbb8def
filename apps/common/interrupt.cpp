#include "common/interrupt.hpp"

#include <csignal>

namespace isostretch::app {
namespace {

// Made before any signal can come.
const StopSource& source() {
  static const StopSource instance;
  return instance;
}

extern "C" void note_signal(int) {
  source().request_stop();
  // Whichever of the two comes second ends the program, also when it is not the one that came first.
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

}  // namespace

void catch_interrupts() {
  source();
  std::signal(SIGINT, note_signal);
  std::signal(SIGTERM, note_signal);
}

StopToken interrupt_token() {
  return source().token();
}

bool interrupted() noexcept {
  return interrupt_token().stop_requested();
}

}  // namespace isostretch::app
