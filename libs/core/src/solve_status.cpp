#include <isostretch/core/solve_status.hpp>

namespace isostretch {

std::string_view solve_status_name(SolveStatus status) noexcept {
  switch (status) {
    case SolveStatus::not_run:
      return "not_run";
    case SolveStatus::converged:
      return "converged";
    case SolveStatus::stalled:
      return "stalled";
    case SolveStatus::iteration_limit:
      return "iteration_limit";
    case SolveStatus::time_limit:
      return "time_limit";
    case SolveStatus::interrupted:
      return "interrupted";
    case SolveStatus::infeasible:
      return "infeasible";
    case SolveStatus::not_applicable:
      return "not_applicable";
    case SolveStatus::failed:
      break;
  }
  return "failed";
}

}  // namespace isostretch
