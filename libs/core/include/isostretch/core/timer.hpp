#pragma once

#include <chrono>

namespace isostretch {

/// A clock that measures wall-clock seconds since its construction.
class Timer {
 public:
  /// Returns the seconds since construction.
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

/// A timer that adds its lifetime to a counter of seconds.
class ScopedTimer {
 public:
  /// Makes a timer that adds to `seconds` when it is destroyed; the counter must outlive it.
  explicit ScopedTimer(double& seconds) : seconds_(seconds) {}
  /// Adds the seconds since construction to the counter.
  ~ScopedTimer() { seconds_ += timer_.seconds(); }
  ScopedTimer(const ScopedTimer&) = delete;
  ScopedTimer& operator=(const ScopedTimer&) = delete;

 private:
  double& seconds_;
  Timer timer_;
};

}  // namespace isostretch
