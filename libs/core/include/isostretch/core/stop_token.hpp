#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <memory>
#include <optional>

namespace isostretch {

/// A token that tells running methods to end: by a request that anybody may make while they run, or by a
/// deadline. Methods ask it between iterations and end with the best positions that they have. Copies share
/// the request.
///
/// A token made without a StopSource has no request; it ends a method only if it is given a deadline.
class StopToken {
 public:
  /// Makes a token without a request and without a deadline.
  StopToken() = default;

  /// Returns whether the StopSource of this token was asked to stop.
  bool stop_requested() const noexcept { return request_ != nullptr && request_->load(); }
  /// Returns whether the deadline has passed; false without one.
  bool deadline_passed() const { return deadline_ && Clock::now() >= *deadline_; }
  /// Returns whether a method has to end, on request or because the deadline has passed.
  bool should_stop() const { return stop_requested() || deadline_passed(); }

  /// Returns the seconds until the deadline, at least 0; infinity without a deadline.
  double seconds_left() const {
    if (!deadline_) return std::numeric_limits<double>::infinity();
    return std::max(std::chrono::duration<double>(*deadline_ - Clock::now()).count(), 0.0);
  }

  /// Returns a token with the same request whose deadline is `seconds` from now, or the present deadline if
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
  /// In seconds, because the clock counts no further than 292 years.
  static constexpr double longest_time_limit = 1e9;
  friend class StopSource;

  std::shared_ptr<const std::atomic<bool>> request_;
  std::optional<Clock::time_point> deadline_;
};

/// A source of tokens through which running methods are asked to stop.
class StopSource {
 public:
  /// Asks all methods that have a token of this source to stop. May be called from any thread and from a
  /// signal handler.
  StopSource() : request_(std::make_shared<std::atomic<bool>>(false)) {}

  /// Returns a token of this source, without a deadline.
  void request_stop() const noexcept { request_->store(true); }
  /// Returns a token of this source, without a deadline. 69-
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
