#pragma once

#include <isostretch/baselines/solver.hpp>
#include <isostretch/core/monitor.hpp>
#include <isostretch/deformation/manipulation.hpp>

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace isostretch::comparison {

/// A frame of a manipulation, made by the library or by a rival. `summary` has of a rival what it has of it,
/// without a status.
struct ManipulationFrame : deformation::ManipulationFrame {
  std::optional<baselines::Result> rival = {};  ///< The rival's account of it, where one made it.

  /// Returns whether it has a certificate, which rivals do not give.
  bool certified() const { return !rival && summary.status == sdp_penalty::Status::optimal; }
  /// Returns whether it ended as it should: certified, or by a rival's own account at its goal.
  bool reached() const { return rival ? rival->status == baselines::Status::converged : certified(); }
  /// Returns whether it was ended on request or by the limit of time.
  bool stopped() const { return (rival ? rival->outcome() : summary.outcome()) == SolveStatus::interrupted; }
  /// Returns the name of its status.
  std::string_view status() const {
    return rival ? baselines::status_name(rival->status) : sdp_penalty::status_name(summary.status);
  }
};

/// By whom frames are made, and what is allowed.
struct FrameSolverOptions {
  std::string rival = {};   ///< a solver of baselines in the place of the library's; empty: none
  double memory_limit = 0;  ///< megabytes that a rival may take; 0: none
  /// Returns why frames are to end now, in words for messages.
  std::function<std::string()> stop_reason = [] { return std::string(); };
};

/// A solver of frames, each for itself.
class FrameSolver {
 public:
  /// Prepares the frames. All references must outlive this object. The token of the monitor ends a frame
  /// after an iteration.
  FrameSolver(const deformation::ManipulationOptions& manipulation, const deformation::SolidModel& body,
              const deformation::HandleSet& handle_set, const deformation::ElementRotations& rotations,
              const Monitor& monitor, FrameSolverOptions options);

  /// Makes a frame, 1 to the number of frames of the script.
  ManipulationFrame solve(int frame);

 private:
  ManipulationFrame solve_by_rival(int frame);
  void run_rival(ManipulationFrame& result);

  const deformation::ManipulationOptions& scene_;
  FrameSolverOptions options_;
  Monitor monitor_;
  Vector rest_;
  deformation::Manipulation manipulation_;
};

}  // namespace isostretch::comparison
