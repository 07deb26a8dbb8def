#pragma once

#include <isostretch/core/monitor.hpp>
#include <isostretch/deformation/interpolation_options.hpp>
#include <isostretch/deformation/interpolation_start.hpp>
#include <isostretch/deformation/rigid_placement.hpp>
#include <isostretch/deformation/shape_energy.hpp>
#include <isostretch/newton/solver.hpp>

#include <array>
#include <string>

namespace isostretch::deformation {

/// One frame, the poses at both ends included, which nothing is solved for.
struct InterpolationFrame {
  int number = 0;
  double time = 0;
  bool solved = true;       ///< false: a pose
  newton::Summary summary;  ///< of the solve
  std::string start;        ///< name of where it began
  double seconds = 0;       ///< from the start on
  Vector settled;           ///< the shape; see RigidPlacement
  std::array<double, 2> psi;
  double change = 0;      ///< distance from the frame before, without rigid motion, over the diagonal
  bool complete() const;  ///< the sequence can go on
};

/// Makes frames in their order.
class Interpolation {
 public:
  /// Throws Error unless both shapes belong together (require_pair) and the energy has its least value at
  /// rest, and OptionError without frames.
  Interpolation(const InterpolationOptions& options, const KeyShapes& poses,
                const energies::AnyEnergy& energy, const Monitor& monitor = {});

  /// The next one. A request to stop and the limit of time end it after an iteration.
  InterpolationFrame next();
  bool done() const { return number_ > options_.frames; }
  /// Positions of a frame in its place between the poses. They depend on all frames: call it after the last.
  Vector placed(const InterpolationFrame& frame) const;

 private:
  InterpolationFrame pose(Vector settled);
  InterpolationFrame solved();
  newton::Summary minimize(Vector& positions);
  void measure(InterpolationFrame& frame);

  const InterpolationOptions options_;
  Monitor monitor_;
  RigidPlacement placement_;
  ShapeEnergy energy_;
  newton::Solver solver_;
  ExtrapolatedStart starts_;
  Vector before_;  ///< the frame before, settled
  double diagonal_;
  int number_ = 0;
};

}  // namespace isostretch::deformation
