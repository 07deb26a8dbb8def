#pragma once

#include "common/deformation_names.hpp"

#include "options.hpp"
#include "scene.hpp"

#include <isostretch/baselines/solver.hpp>
#include <isostretch/core/timer.hpp>
#include <isostretch/deformation/manipulation.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace isostretch::app::manipulate {

// What became of one frame, made by the library or by a rival. `summary` has of a rival what it has of it,
// without a status.
struct FrameResult : deformation::ManipulationFrame {
  std::optional<baselines::Result> rival = {};

  bool certified() const { return !rival && summary.status == sdp_penalty::Status::optimal; }
  // As it should end: certified, or by a rival's own account at its goal.
  bool reached() const { return rival ? rival->status == baselines::Status::converged : certified(); }
  bool stopped() const { return (rival ? rival->outcome() : summary.outcome()) == SolveStatus::interrupted; }
  std::string_view status() const {
    return rival ? baselines::status_name(rival->status) : sdp_penalty::status_name(summary.status);
  }
};

// Solves frames, each for itself, by the solver that the scene names.
class FrameSolver {
 public:
  FrameSolver(const Scene& scene, const deformation::SolidModel& body,
              const deformation::HandleSet& handle_set, const deformation::ElementRotations& rotations,
              const Options& options);

  // Ctrl-C and the time limit end it after an iteration.
  FrameResult solve(int frame);

  // The reason to begin no other frame, if there is one.
  std::string halt() const;

 private:
  FrameResult solve_by_rival(int frame);
  void run_rival(FrameResult& result);

  const Scene& scene_;
  const Options& options_;
  Monitor monitor_;
  Vector rest_;
  deformation::Manipulation manipulation_;
};

}  // namespace isostretch::app::manipulate
