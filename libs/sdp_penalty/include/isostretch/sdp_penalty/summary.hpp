#pragma once

#include <isostretch/core/solve_status.hpp>
#include <isostretch/core/trace.hpp>

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace isostretch::sdp_penalty {

/// How a solve ended, in the words of this problem; outcome() has those of all methods.
enum class Status {
  not_run,
  optimal,  ///< feasible, and the certified gap is within the tolerance
  /// No x to speak of is strictly feasible: the ex-rotations (or hard targets) contradict each other.
  infeasible,
  /// The method can do no more: the last penalty factor, or x is feasible and rounding leaves the gap.
  path_end,
  iterations,  ///< max_iterations reached
  callback,    ///< stopped by the callback, or by the token
  failed       ///< rounding or a failed factorization ended it
};

/// Returns the enumerator's own name.
std::string_view status_name(Status status) noexcept;
/// Returns the status in the words that all methods share.
SolveStatus outcome(Status status) noexcept;

/// One row of the trace. Row 0 is the unconstrained minimiser, the minimiser without constraints.
struct Iteration {
  int iteration = 0;
  double seconds = 0;  ///< since the solve began
  double energy = 0;
  double lower_bound = 0;      ///< on the energy of every feasible x, whatever this iterate is
  double min_eigenvalue = 0;   ///< of all S_i
  double complementarity = 0;  ///< interior point: mean eigenvalue of Z Y, the distance from the boundary
  double penalty_factor = 0;   ///< tau, of the methods that have one
  double step = 0;
  int inverted = 0;    ///< elements with det F <= 0
  int infeasible = 0;  ///< elements with an eigenvalue of S below the margin
};

/// How a solve ended, what is known of its x, and its trace.
struct Summary {
  Status status = Status::not_run;
  std::string message = "not run";
  int iterations = 0;
  int linear_solves = 0;  ///< factorizations, with that of H0 unless an earlier solve had made it
  double energy = std::numeric_limits<double>::quiet_NaN();
  double target_energy = std::numeric_limits<double>::quiet_NaN();
  double lower_bound = -std::numeric_limits<double>::infinity();
  /// (energy - lower_bound) / max(|energy|, |lower_bound|): no feasible x is better by more than that. Only
  /// for a feasible x; NaN otherwise.
  double gap = std::numeric_limits<double>::quiet_NaN();
  double min_eigenvalue = std::numeric_limits<double>::quiet_NaN();
  double min_determinant = std::numeric_limits<double>::quiet_NaN();
  int inverted = -1;  ///< -1: not known
  int infeasible = -1;
  double seconds = 0;
  /// Where the solver gave up (not: unconstrained, the callback's stop): ten elements (or all) with the
  /// largest multipliers, largest first. Where they grow beyond bounds no x is strictly feasible: the
  /// ex-rotations there contradict each other.
  std::vector<int> infeasible_elements;
  /// Of `infeasible`: no x whose nodes are all within `extent` of the middle of the targets, on every axis,
  /// has S_i >= this for all elements. Rigorous up to rounding.
  double unreachable_eigenvalue = std::numeric_limits<double>::quiet_NaN();
  double extent = std::numeric_limits<double>::quiet_NaN();
  std::vector<Iteration> trace;

  /// Returns whether all constraints hold at x.
  bool feasible() const { return infeasible == 0; }
  /// Returns the status in the words that all methods share.
  SolveStatus outcome() const { return sdp_penalty::outcome(status); }
};

/// Returns the trace as a table: iteration, seconds, energy, lower_bound, gap, min_eigenvalue,
/// complementarity, penalty_factor, step, inverted, infeasible. The gap is relative.
Trace trace_table(const Summary& summary);

}  // namespace isostretch::sdp_penalty
