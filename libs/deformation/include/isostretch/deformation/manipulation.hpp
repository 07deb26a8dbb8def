#pragma once

#include <isostretch/core/monitor.hpp>
#include <isostretch/deformation/element_rotations.hpp>
#include <isostretch/deformation/iterate_path.hpp>
#include <isostretch/deformation/manipulation_options.hpp>
#include <isostretch/sdp_penalty/relinearize.hpp>

#include <string>
#include <vector>

namespace isostretch::deformation {

/// What became of one frame of a manipulation.
struct ManipulationFrame {
  int frame = 0;
  double time = 0;
  sdp_penalty::Summary summary;
  std::string trouble = {};            ///< why there are no positions; empty where there are
  std::vector<double> given = {};      ///< ex-rotations of the elements, [element][dim * dim], row by row
  std::vector<double> rotations = {};  ///< those of the last round where it was re-linearised, else the same
  Vector positions = {};
  Vector before = {};  ///< the minimiser without constraints
  IteratePath path = {};
  std::vector<sdp_penalty::RelinearizeRound> rounds = {};  ///< where they were asked for
  double seconds = 0;

  bool made() const { return trouble.empty(); }
};

/// Manipulates a body without inverting an element, frame by frame, each frame for itself: handles in their
/// places, ex-rotations from those of the handles, and the convex problem of both solved to a certificate.
/// The sparsity, its analysis and the factor of the unconstrained problem are kept from frame to frame.
class Manipulation {
 public:
  /// All that is given must live longer.
  Manipulation(const ManipulationOptions& options, const SolidModel& body, const HandleSet& handle_set,
               const ElementRotations& rotations, const Monitor& monitor = {});

  /// Makes a frame, 1 to options.script.frames. A request to stop, and the deadline of the monitor's token,
  /// end it after an iteration.
  ManipulationFrame solve(int frame);

  /// Prepares a frame without solving it, and returns its problem: for solvers of others. Throws Error naming
  /// the element where the handles' rotations cancel each other.
  const sdp_penalty::Problem& prepare(ManipulationFrame& frame);
  /// Returns the minimiser of the prepared problem without constraints; its time is nobody's.
  Vector unconstrained() const;
  /// Puts nodes that nothing holds, of components without a handle and of no element, where they are at rest.
  void put_loose_nodes_back(Vector& positions) const;

 private:
  void find_loose_nodes();
  void place_targets(double time);
  void run(ManipulationFrame& result);
  void relinearize(ManipulationFrame& result);
  std::string stop_reason() const;

  const ManipulationOptions& options_;
  const SolidModel& body_;
  const HandleSet& handle_set_;
  const ElementRotations& rotations_;
  Monitor monitor_;
  Vector rest_;
  std::vector<int> loose_nodes_;
  std::vector<int> loose_holds_;  ///< one a component, and those of no element
  sdp_penalty::Problem problem_;
  sdp_penalty::Solver solver_;
};

/// Returns an iteration of a manipulation as a line to follow it by.
std::string progress_line(const sdp_penalty::Iteration& row);

}  // namespace isostretch::deformation
