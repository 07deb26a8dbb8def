#include <isostretch/baselines/result.hpp>

namespace isostretch::baselines {

std::string_view status_name(Status status) noexcept {
  switch (status) {
    case Status::not_run:
      return "not_run";
    case Status::converged:
      return "converged";
    case Status::stalled:
      return "stalled";
    case Status::iteration_limit:
      return "iteration_limit";
    case Status::time_limit:
      return "time_limit";
    case Status::memory_limit:
      return "memory_limit";
    case Status::claims_infeasible:
      return "claims_infeasible";
    case Status::not_applicable:
      return "not_applicable";
    case Status::unavailable:
      return "unavailable";
    case Status::failed:
      return "failed";
    case Status::crashed:
      return "crashed";
    case Status::unreadable:
      return "unreadable";
    case Status::callback:
      return "callback";
  }
  return "unknown";
}

SolveStatus outcome(Status status) noexcept {
  switch (status) {
    case Status::not_run:
      return SolveStatus::not_run;
    case Status::converged:
      return SolveStatus::converged;
    case Status::stalled:
      return SolveStatus::stalled;
    case Status::iteration_limit:
      return SolveStatus::iteration_limit;
    case Status::time_limit:
      return SolveStatus::time_limit;
    case Status::callback:
      return SolveStatus::interrupted;
    case Status::claims_infeasible:
      return SolveStatus::infeasible;
    case Status::not_applicable:
    case Status::unavailable:
      return SolveStatus::not_applicable;
    case Status::memory_limit:
    case Status::failed:
    case Status::crashed:
    case Status::unreadable:
      break;
  }
  return SolveStatus::failed;
}

Trace trace_table(const Result& result) {
  Trace trace{{"iteration", "seconds", "energy", "min_eigenvalue", "min_det_F", "distortion", "inverted",
               "infeasible"},
              {}};
  for (const Point& point : result.trace) {
    const Measures& m = point.measures;
    trace.rows.push_back({static_cast<double>(point.iteration), point.seconds, m.energy, m.min_eigenvalue,
                          m.min_determinant, m.distortion, static_cast<double>(m.inverted),
                          static_cast<double>(m.infeasible)});
  }
  return trace;
}

}  // namespace isostretch::baselines
