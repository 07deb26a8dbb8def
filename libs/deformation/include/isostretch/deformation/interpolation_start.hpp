#pragma once

#include <isostretch/deformation/interpolation_options.hpp>
#include <isostretch/deformation/rigid_placement.hpp>
#include <isostretch/deformation/shape_energy.hpp>

#include <string>
#include <vector>

namespace isostretch::deformation {

/// A named initial guess of a frame.
struct FrameStart {
  std::string name;  ///< "previous", "extrapolated_2", "towards_second_1", ...
  Vector positions;  ///< Positions, dim entries per node.
};

/// A chooser of initial guesses: the frame before, or a polynomial through the last ones, up to four, which
/// may besides end in the second key shape. The one of least energy is taken; each costs an evaluation of it.
class ExtrapolatedStart {
 public:
  /// Makes a chooser without frames; `placement` must outlive it.
  ExtrapolatedStart(Continuation kind, const RigidPlacement& placement);

  /// Adds a frame that was solved and settled, at time t.
  void add(double t, const Vector& settled);
  /// Returns the guess of least energy at time t, to which the energy must be set.
  FrameStart start(double t, ShapeEnergy& energy) const;

 private:
  struct Sample {
    double t;
    Vector positions;
  };
  /// Returns the polynomial at time t through the last frames and `end`, at time 1, unless that is null.
  Vector continued(double t, std::size_t frames, const Vector* end) const;

  Continuation kind_;
  const RigidPlacement& placement_;
  std::vector<Sample> last_;  ///< Frames, newest first.
};

}  // namespace isostretch::deformation
