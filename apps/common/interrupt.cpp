#include "common/interrupt.hpp"

#include <csignal>

namespace isostretch::app {
namespace {

volatile std::sig_atomic_t signal_seen = 0;

extern "C" void note_signal(int) {
  signal_seen = 1;
  // Whichever of the two comes second ends the program, also when it is not the one that came first.
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, note_signal);
  std::signal(SIGTERM, note_signal);
}

bool interrupted() noexcept {
  return signal_seen != 0;
}

}  // namespace isostretch::app
