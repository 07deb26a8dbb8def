#include <isostretch/sdp_penalty/summary.hpp>

namespace isostretch::sdp_penalty {

std::string_view status_name(Status status) noexcept {
  switch (status) {
    case Status::not_run:
      return "not_run";
    case Status::optimal:
      return "optimal";
    case Status::inadmissible:
      return "inadmissible";
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

}  // namespace isostretch::sdp_penalty
