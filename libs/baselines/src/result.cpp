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
    case Status::unsuited:
      return "unsuited";
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

}  // namespace isostretch::baselines
