#pragma once

#include <isostretch/core/solve_status.hpp>
#include <isostretch/core/stop_token.hpp>
#include <isostretch/core/timer.hpp>
#include <isostretch/core/vector.hpp>

#include <functional>
#include <string>
#include <utility>

namespace isostretch {

/// Does for an iterative method what all of them do around their steps: clock, trace, callback, requests to
/// stop, limits and the end.
///
/// The summary, which must outlive the driver, has a status (Status::not_run at first), a message, a count of
/// iterations, and a trace of rows with an iteration and seconds. The clock starts with the driver.
template <class Summary>
class IterationDriver {
 public:
  /// The status of the method.
  using Status = decltype(Summary::status);
  /// A row of its trace.
  using Row = typename decltype(Summary::trace)::value_type;
  /// A function that is shown every iterate, and may end the method.
  using Callback = std::function<CallbackAction(const Row& row, const Vector& x)>;

  /// `interrupted` is the status of a solve that the callback or the token ends; the callback may be empty.
  IterationDriver(Summary& summary, Callback callback, StopToken stop, Status interrupted)
      : summary_(summary),
        callback_(std::move(callback)),
        stop_(std::move(stop)),
        interrupted_(interrupted) {}

  /// Returns the seconds since the solve began.
  double seconds() const { return timer_.seconds(); }
  /// Returns whether the solve has a status.
  bool ended() const { return summary_.status != Status::not_run; }

  /// Ends the solve, unless it has ended: the first reason stays. Returns false, as there is no step to come.
  bool end(Status status, std::string message) {
    if (ended()) return false;
    summary_.status = status;
    summary_.message = std::move(message);
    return false;
  }

  /// Adds the row of the iterate x to the trace, with the number of iterations and the seconds so far, and
  /// shows it to the callback. Returns whether the solve goes on.
  bool record(Row row, const Vector& x) {
    row.iteration = summary_.iterations;
    row.seconds = seconds();
    summary_.trace.push_back(row);
    if (callback_ && callback_(row, x) == CallbackAction::stop)
      return end(interrupted_, "stopped by the callback");
    if (stop_.stop_requested()) return end(interrupted_, "interrupted");
    return !ended();
  }

  /// Returns the limit that the solve has come to, iteration_limit or time_limit, and not_run while there is
  /// none. The time limit is in seconds, 0 for none; the deadline of the token counts besides.
  SolveStatus limit_reached(int max_iterations, double time_limit = 0) const {
    if (summary_.iterations >= max_iterations) return SolveStatus::iteration_limit;
    if ((time_limit > 0 && seconds() >= time_limit) || stop_.deadline_passed())
      return SolveStatus::time_limit;
    return SolveStatus::not_run;
  }

 private:
  Timer timer_;  ///< first: what the other members take counts
  Summary& summary_;
  Callback callback_;
  StopToken stop_;
  Status interrupted_;
};

}  // namespace isostretch
