#include <isostretch/sdp_penalty/summary.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::sdp_penalty {

std::string_view status_name(Status status) noexcept {
  switch (status) {
    case Status::not_run:
      return "not_run";
    case Status::optimal:
      return "optimal";
    case Status::infeasible:
      return "infeasible";
    case Status::path_end:
      return "path_end";
    case Status::iterations:
      return "iterations";
    case Status::callback:
      return "callback";
    case Status::failed:
      return "failed";
  }
  return "?";
}

SolveStatus outcome(Status status) noexcept {
  switch (status) {
    case Status::not_run:
      return SolveStatus::not_run;
    case Status::optimal:
      return SolveStatus::converged;
    case Status::infeasible:
      return SolveStatus::infeasible;
    case Status::path_end:
      return SolveStatus::stalled;
    case Status::iterations:
      return SolveStatus::iteration_limit;
    case Status::callback:
      return SolveStatus::interrupted;
    case Status::failed:
      break;
  }
  return SolveStatus::failed;
}

Trace trace_table(const Summary& summary) {
  Trace trace{{"iteration", "seconds", "energy", "lower_bound", "gap", "min_eigenvalue", "complementarity",
               "penalty_factor", "step", "inverted", "infeasible"},
              {}};
  for (const Iteration& row : summary.trace) {
    constexpr double smallest_size = 1e-300;
    const double gap = (row.energy - row.lower_bound) /
                       std::max({std::abs(row.energy), std::abs(row.lower_bound), smallest_size});
    trace.rows.push_back({static_cast<double>(row.iteration), row.seconds, row.energy, row.lower_bound, gap,
                          row.min_eigenvalue, row.complementarity, row.penalty_factor, row.step,
                          static_cast<double>(row.inverted), static_cast<double>(row.infeasible)});
  }
  return trace;
}

}  // namespace isostretch::sdp_penalty
