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

/// A frame of an interpolation. Those at both ends are the key shapes, for which nothing is solved.
struct InterpolationFrame {
  int number = 0;           ///< Number of the frame.
  double time = 0;          ///< Time, 0 at the first key shape and 1 at the second.
  bool solved = true;       ///< Whether it was solved for; false for a key shape.
  newton::Summary summary;  ///< Summary of the solve.
  std::string start;        ///< Name of the initial guess.
  double seconds = 0;       ///< Seconds from the start on.
  Vector settled;  ///< Positions without the rigid motion between the key shapes, see RigidPlacement.
  std::array<double, 2> psi;  ///< Energies over both key shapes.
  double change = 0;          ///< Distance from the frame before, without rigid motion, over the diagonal.
  bool complete() const;      ///< Returns whether the sequence can go on.
};

/// An interpolation between key shapes that makes frames in their order.
class Interpolation {
 public:
  /// Prepares the frames. Throws Error unless both shapes belong together, see require_pair(), and the energy
  /// has its least value at rest, and OptionError without frames.
  Interpolation(const InterpolationOptions& options, const KeyShapes& key_shapes,
                const energies::AnyEnergy& energy, const Monitor& monitor = {});

  /// Makes the next frame. A request to stop and the limit of time end it after an iteration.
  InterpolationFrame next();
  /// Returns whether all frames are made.
  bool done() const { return number_ > options_.frames; }
  /// Returns the positions of a frame in its place between the key shapes. They depend on all frames: call it
  /// after the last.
  Vector placed(const InterpolationFrame& frame) const;

 private:
  InterpolationFrame key_frame(Vector settled);
  InterpolationFrame solved();
  newton::Summary minimize(Vector& positions);
  void measure(InterpolationFrame& frame);

  const InterpolationOptions options_;
  Monitor monitor_;
  RigidPlacement placement_;
  ShapeEnergy energy_;
  newton::Solver solver_;
  ExtrapolatedStart starts_;
  Vector before_;  ///< Positions of the frame before.
  double diagonal_;
  int number_ = 0;
};

}  // namespace isostretch::deformation
