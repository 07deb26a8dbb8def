#pragma once

#include <string_view>

namespace isostretch {

/// The ways in which an iterative method ends, the same for the methods of all libraries. Methods say more in
/// statuses of their own, and in the message of their summary.
enum class SolveStatus {
  /// The method has not been run.
  not_run,
  converged,        ///< A stopping rule of the method holds.
  stalled,          ///< There was no more progress before a stopping rule held, or a path came to its end.
  iteration_limit,  ///< The method took as many iterations as were allowed.
  time_limit,       ///< The method took as much time as was allowed.
  interrupted,      ///< A StopToken or a callback ended the method.
  infeasible,       ///< There is no solution, or none that the method can reach.
  not_applicable,   ///< The method does not take such a problem, or is not installed.
  failed            ///< The method failed: rounding, memory, a factorization, or values that are not finite.
};

/// Returns the name of the enumerator, such as "time_limit".
std::string_view solve_status_name(SolveStatus status) noexcept;

/// The answer of a callback that sees every iteration: go on, or end the method.
enum class CallbackAction { proceed, stop };

}  // namespace isostretch
