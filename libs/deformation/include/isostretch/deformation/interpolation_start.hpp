#pragma once

#include <isostretch/deformation/interpolation_options.hpp>
#include <isostretch/deformation/rigid_placement.hpp>
#include <isostretch/deformation/shape_energy.hpp>

#include <string>
#include <vector>

namespace isostretch::deformation {

struct FrameStart {
  std::string name;  ///< "previous", "extrapolated_2", "towards_second_1", ...
  Vector positions;
};

/// Where frames start from: the frame before, or a polynomial through the last ones, up to four, which may
/// besides end in the second pose. The one of least energy is taken; each costs an evaluation of it.
class ExtrapolatedStart {
 public:
  ExtrapolatedStart(Continuation kind, const RigidPlacement& placement);

  /// A frame that was solved and settled.
  void add(double t, const Vector& settled);
  /// The energy must be set to t.
  FrameStart start(double t, ShapeEnergy& energy) const;

 private:
  struct Sample {
    double t;
    Vector positions;
  };
  /// `end` is at the time 1, or null.
  Vector continued(double t, std::size_t frames, const Vector* end) const;

  Continuation kind_;
  const RigidPlacement& placement_;
  std::vector<Sample> last_;  ///< frames, newest first
};

}  // namespace isostretch::deformation
