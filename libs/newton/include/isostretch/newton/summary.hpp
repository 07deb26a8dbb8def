#pragma once

#include <isostretch/core/phase_times.hpp>
#include <isostretch/core/solve_status.hpp>
#include <isostretch/core/trace.hpp>
#include <isostretch/projection/filter.hpp>

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace isostretch::newton {

/// How a solve ended, and by which test; outcome() has the words of all methods.
enum class Status {
  not_run,
  converged_gradient,         ///< gradient_tolerance
  converged_scaled_gradient,  ///< scaled_gradient_tolerance
  converged_decrement,        ///< decrement_tolerance
  converged_energy,           ///< relative_energy_tolerance
  converged_roundoff,         ///< no step lowers the energy by more than its rounding
  stopped_iterations,
  stopped_time,
  stopped_by_callback,
  failed_start,          ///< energy, gradient or Hessian not finite at the start
  failed_derivatives,    ///< gradient or Hessian not finite at positions with a finite energy
  failed_factorization,  ///< not even the fully filtered and shifted Hessian factorises
  failed_line_search,    ///< no step along a descent direction lowers the energy
};

/// Returns the enumerator's own name.
std::string_view status_name(Status status) noexcept;
/// Returns whether a stopping test has held.
bool converged(Status status) noexcept;
/// Returns whether the solve could not go on.
bool failed(Status status) noexcept;
/// Returns the status in the words that all methods share.
SolveStatus outcome(Status status) noexcept;

/// One row of the trace. Row 0 is the start.
struct Iteration {
  /// The number of the iteration, from 0.
  int iteration = 0;
  double seconds = 0;  ///< since the solve began
  /// The energy.
  double energy = 0;
  /// The largest absolute value in the gradient.
  double gradient_inf_norm = 0;
  /// The length of the step that the line search took.
  double step = 0;
  double decrement = 0;  ///< 1/2 gradient . H^-1 gradient of the step that led here
  /// The gain of the first step tried over the gain that the quadratic model promised.
  double model_fit = 0;
  /// 0: exact Hessian, 1/2: negative eigenvalues to zero, 1: to their absolute value, and between.
  double projection_weight = 0;
  /// The number of quadrature points with a filtered eigenvalue.
  std::size_t points_filtered = 0;
  int factorizations = 0;  ///< tried for this step
  /// The number of evaluations of the energy by the line search.
  int evaluations = 0;
};

/// Wall-clock seconds by phase.
struct Seconds {
  /// Wall time of the whole solve.
  double total = 0;
  double setup = 0;     ///< pattern and symbolic factorization
  double assembly = 0;  ///< energy, gradient, filtered Hessian, filled matrix
  /// Time of numeric factorizations.
  double factorization = 0;
  /// Time of solves with a factor.
  double solve = 0;
  /// Time of line searches.
  double line_search = 0;

  /// Returns the phases by name; "minimize" is the total.
  PhaseTimes phases() const;
};

/// How a solve ended, and its course.
struct Summary {
  /// How the solve ended.
  Status status = Status::not_run;
  /// A sentence on how it ended.
  std::string message = "minimize() was not called";
  /// The number of iterations.
  int iterations = 0;
  int factorizations = 0;  ///< tried
  /// The number of factorizations that met a matrix which is not positive definite.
  int failed_factorizations = 0;
  /// The number of evaluations of the energy.
  int energy_evaluations = 0;
  /// The energy at the start.
  double initial_energy = std::numeric_limits<double>::quiet_NaN();
  /// The energy at the end.
  double energy = std::numeric_limits<double>::quiet_NaN();
  /// The largest absolute value in the gradient at the end.
  double gradient_inf_norm = std::numeric_limits<double>::quiet_NaN();
  /// The time of the phases.
  Seconds seconds;
  std::string solver;  ///< back end, and ordering or preconditioner at work
  /// The nonzeros of the factor; 0 where there is none.
  double factor_nonzeros = 0;
  /// A row for the start and every iteration.
  std::vector<Iteration> trace;

  /// Returns whether a test of convergence held.
  bool converged() const { return newton::converged(status); }
  /// Returns how the solve ended, in the words that all methods share.
  SolveStatus outcome() const { return newton::outcome(status); }
  /// Adds the iterations, factorizations, evaluations and seconds of another solve. Energies, status and
  /// trace stay.
  void add_effort(const Summary& other);
  /// Returns one line, made of the struct alone.
  std::string brief_report() const;
  /// Returns all there is to say, made of the struct alone.
  std::string full_report() const;
};

/// Returns an iteration as a line to follow a solve by.
std::string progress_line(const Iteration& row);

/// Returns the trace as a table: iteration, seconds, energy, gradient_inf_norm, step, decrement,
/// projection_weight, points_filtered, factorizations, evaluations.
Trace trace_table(const Summary& summary);

}  // namespace isostretch::newton
