#pragma once

#include <isostretch/baselines/measures.hpp>
#include <isostretch/core/phase_times.hpp>
#include <isostretch/core/solve_status.hpp>
#include <isostretch/core/trace.hpp>
#include <isostretch/core/vector.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace isostretch::baselines {

/// How a run ended, by the solver's own account. How good its positions are is a matter of the measures.
enum class Status {
  not_run,
  converged,          ///< its own stopping rule
  stalled,            ///< it gave up before: no more progress, or its path ended
  iteration_limit,    ///< Limits::iterations, or its own
  time_limit,         ///< the deadline of Options::stop
  memory_limit,       ///< Limits::megabytes, or there was no more
  claims_infeasible,  ///< it says that the problem has no (strictly) feasible point
  not_applicable,     ///< it does not take this instance: too large, or of the wrong kind
  unavailable,        ///< not found when this was built, or not installed where it runs
  failed,             ///< its own error
  crashed,            ///< its process was ended by a signal that nobody here sent
  unreadable,         ///< what it wrote is no answer
  callback            ///< stopped by the callback, or by a request of Options::stop
};

/// Returns the enumerator's own name.
std::string_view status_name(Status status) noexcept;
/// Returns the status in the words that all methods share.
SolveStatus outcome(Status status) noexcept;

/// Wall-clock seconds, measuring positions for the trace not counted.
struct Seconds {
  double modelling = 0;  ///< from the instance to what the solver takes, files included
  double solving = 0;    ///< the solver, or its process
  double reading = 0;    ///< from its answer to positions
  /// Returns the sum of the phases.
  double total() const { return modelling + solving + reading; }
};

/// An iterate on the way. Solvers that show none have the start, if any, and the end alone.
struct Point {
  /// The number of the iterate, from 0.
  int iteration = 0;
  double seconds = 0;  ///< Seconds::total() so far
  /// The measures of the iterate.
  Measures measures;
};

/// The result of a solver.
struct Result {
  /// How the run ended.
  Status status = Status::not_run;
  /// A sentence on how it ended, from the solver or about what stopped it.
  std::string message = "not run";
  Vector x;  ///< empty where the solver left nothing
  /// The measures of x.
  Measures measures;
  double lower_bound = -std::numeric_limits<double>::infinity();  ///< where the solver proves one
  int iterations = 0;                                             ///< in the solver's own count
  int linear_solves = -1;                                         ///< factorizations, where they are known
  /// The largest memory of its process, where it has one of its own; -1: unknown.
  double peak_megabytes = -1;
  /// The time of its phases.
  Seconds seconds;
  /// The iterates that were recorded.
  std::vector<Point> trace;

  /// Returns whether there are positions.
  bool has_positions() const { return x.size() > 0; }
  /// Returns the status in the words that all methods share.
  SolveStatus outcome() const { return baselines::outcome(status); }
};

/// Returns the trace as a table: iteration, seconds, energy, min_eigenvalue, min_det_F, distortion, inverted,
/// infeasible.
Trace trace_table(const Result& result);

}  // namespace isostretch::baselines
