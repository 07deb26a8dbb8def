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
  /// The number of the iterate; 0 is the unconstrained minimiser.
  int iteration = 0;
  /// Wall time.
  double seconds = 0;
  /// The energy.
  double energy = 0;
  double lower_bound = 0;  ///< on the energy of every feasible x, whatever this iterate is
  /// The least eigenvalue of all S_i.
  double min_eigenvalue = 0;
  double complementarity = 0;  ///< interior point: mean eigenvalue of Z Y, the distance from the boundary
  double penalty_factor = 0;   ///< tau, of the methods that have one
  /// The length of the step, as a share of the direction.
  double step = 0;
  int inverted = 0;    ///< elements with det F <= 0
  int infeasible = 0;  ///< elements with an eigenvalue of S below the margin
};

/// How a solve ended, what is known of its x, and its trace.
struct Summary {
  /// How the solve ended.
  Status status = Status::not_run;
  /// A sentence on how it ended.
  std::string message = "not run";
  /// The number of iterations.
  int iterations = 0;
  int linear_solves = 0;  ///< factorizations, with that of H0 unless an earlier solve had made it
  /// The energy at the end.
  double energy = std::numeric_limits<double>::quiet_NaN();
  /// The part of the energy that soft targets have.
  double target_energy = std::numeric_limits<double>::quiet_NaN();
  /// A proved lower bound on the energy of every feasible x.
  double lower_bound = -std::numeric_limits<double>::infinity();
  /// (energy - lower_bound) / max(|energy|, |lower_bound|): no feasible x is better by more than that. Only
  /// for a feasible x; NaN otherwise.
  double gap = std::numeric_limits<double>::quiet_NaN();
  /// The least eigenvalue of all S_i.
  double min_eigenvalue = std::numeric_limits<double>::quiet_NaN();
  /// The least determinant of all F_i.
  double min_determinant = std::numeric_limits<double>::quiet_NaN();
  int inverted = -1;  ///< -1: not known
  /// The number of elements with an eigenvalue of S below the margin; -1: unknown.
  int infeasible = -1;
  /// Wall time.
  double seconds = 0;
  /// Where the solver gave up (not: unconstrained, the callback's stop): ten elements (or all) with the
  /// largest multipliers, largest first. Where they grow beyond bounds no x is strictly feasible: the
  /// ex-rotations there contradict each other.
  std::vector<int> infeasible_elements;
  /// Proof of the status infeasible: no x whose nodes are all within `extent` of the middle of the targets,
  /// on every axis, has S_i >= this for all elements. Rigorous up to rounding.
  double unreachable_eigenvalue = std::numeric_limits<double>::quiet_NaN();
  /// The half of the box around the targets that the proof is about, as a length.
  double extent = std::numeric_limits<double>::quiet_NaN();
  /// A row for the start and every iteration.
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
