#pragma once

#include <string_view>

namespace isostretch {

/// How an iterative method ended, the same words for every method of every library. Methods say more in
/// statuses of their own, and in the message of their summary.
enum class SolveStatus {
  not_run,
  converged,        ///< a stopping rule of the method holds
  stalled,          ///< no more progress before that, or a path that has come to its end
  iteration_limit,  ///< as many iterations as were allowed
  time_limit,       ///< as much time as was allowed
  interrupted,      ///< by a StopToken or a callback
  infeasible,       ///< there is no solution, or none that the method can reach
  not_applicable,   ///< the method does not take such a problem, or is not installed
  failed            ///< rounding, memory, a factorization, values that are not finite
};

/// Returns the enumerator's own name.
std::string_view solve_status_name(SolveStatus status) noexcept;

/// What a callback that sees every iteration wants of the method.
enum class CallbackAction { proceed, stop };

}  // namespace isostretch
