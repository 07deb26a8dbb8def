#pragma once

#include <isostretch/core/monitor.hpp>
#include <isostretch/deformation/element_rotations.hpp>
#include <isostretch/deformation/iterate_path.hpp>
#include <isostretch/deformation/manipulation_options.hpp>
#include <isostretch/sdp_penalty/relinearize.hpp>

#include <string>
#include <vector>

namespace isostretch::deformation {

/// A frame of a manipulation.
struct ManipulationFrame {
  int frame = 0;                   ///< Number of the frame.
  double time = 0;                 ///< Time in the script.
  sdp_penalty::Summary summary;    ///< Summary of the solve.
  std::string trouble = {};        ///< Reason why there are no positions; empty where there are.
  std::vector<double> given = {};  ///< Ex-rotations of the elements, [element][dim * dim], column by column.
  /// Ex-rotations of the last round where it was re-linearised, else the given ones.
  std::vector<double> rotations = {};
  Vector positions = {};  ///< Positions, dim entries per node.
  Vector before = {};     ///< Minimiser without constraints.
  IteratePath path = {};  ///< Iterates that pictures need.
  /// Rounds of re-linearisation, where they were asked for.
  std::vector<sdp_penalty::RelinearizeRound> rounds = {};
  double seconds = 0;  ///< Seconds of the frame.

  /// Returns whether there are positions.
  bool made() const { return trouble.empty(); }
};

/// A manipulation of a body that inverts no element, frame by frame, each frame for itself: handles in their
/// places, ex-rotations blended from those of the handles, and the convex problem of both solved to a bounded
/// relative duality gap. The sparsity, its analysis and the factor of the unconstrained problem are kept from
/// frame to frame.
class Manipulation {
 public:
  /// Prepares the frames. All arguments must outlive this object.
  Manipulation(const ManipulationOptions& options, const SolidModel& body, const HandleSet& handle_set,
               const ElementRotations& rotations, const Monitor& monitor = {});

  /// Makes a frame, 1 to options.script.frames. A request to stop, and the deadline of the monitor's token,
  /// end it after an iteration.
  ManipulationFrame solve(int frame);

  /// Prepares a frame without solving it, and returns its problem, for other solvers. Throws Error naming the
  /// element where the handles' rotations cancel each other.
  const sdp_penalty::Problem& prepare(ManipulationFrame& frame);
  /// Returns the minimiser of the prepared problem without constraints; its time counts in no frame.
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
  std::vector<int> loose_holds_;  ///< One per component, and those of no element.
  sdp_penalty::Problem problem_;
  sdp_penalty::Solver solver_;
};

/// Returns an iteration of a manipulation as a line by which to follow it.
std::string progress_line(const sdp_penalty::Iteration& row);

}  // namespace isostretch::deformation
