#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <memory>
#include <optional>

namespace isostretch {

/// Tells running methods to end: a request that anybody may make while they run, and a deadline. Methods ask
/// it between iterations and end with the best positions they have. Copies share the request.
///
/// A token that is made without a source never asks anybody to stop.
class StopToken {
 public:
  StopToken() = default;

  /// Returns whether somebody has asked to stop.
  bool stop_requested() const noexcept { return request_ != nullptr && request_->load(); }
  /// Returns whether the deadline has passed.
  bool deadline_passed() const { return deadline_ && Clock::now() >= *deadline_; }
  /// Returns whether a method has to end, for either reason.
  bool should_stop() const { return stop_requested() || deadline_passed(); }

  /// Returns the seconds that are left until the deadline, at least 0; infinity without one.
  double seconds_left() const {
    if (!deadline_) return std::numeric_limits<double>::infinity();
    return std::max(std::chrono::duration<double>(*deadline_ - Clock::now()).count(), 0.0);
  }

  /// Returns a token with the same request whose deadline is so many seconds from now, or the one it has if
  /// that is earlier. 0 or less sets none.
  StopToken with_time_limit(double seconds) const {
    StopToken token = *this;
    if (!(seconds > 0)) return token;
    const auto deadline =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(
                           std::chrono::duration<double>(std::min(seconds, longest_time_limit)));
    if (!token.deadline_ || deadline < *token.deadline_) token.deadline_ = deadline;
    return token;
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr double longest_time_limit = 1e9;  // seconds; the clock counts no further than 292 years
  friend class StopSource;

  std::shared_ptr<const std::atomic<bool>> request_;
  std::optional<Clock::time_point> deadline_;
};

/// Where a request to stop is made.
class StopSource {
 public:
  StopSource() : request_(std::make_shared<std::atomic<bool>>(false)) {}

  /// Asks all that have a token of this source to stop. May be called from any thread and from a signal
  /// handler.
  void request_stop() const noexcept { request_->store(true); }
  StopToken token() const {
    StopToken token;
    token.request_ = request_;
    return token;
  }

 private:
  static_assert(std::atomic<bool>::is_always_lock_free);  // which signal handlers need
  std::shared_ptr<std::atomic<bool>> request_;
};

}  // namespace isostretch
