#pragma once

#include "options.hpp"
#include "placement.hpp"
#include "shape_energy.hpp"

#include <string>
#include <vector>

namespace isostretch::app::interpolate {

struct Start {
  std::string name;  // "previous", "extrapolated_2", "towards_second_1", ...
  Vector positions;
};

// Where frames start from: the frame before, or a polynomial through the last ones, up to four, which may
// besides end in the second pose. The one of least energy is taken; each costs an evaluation of it.
class Guesser {
 public:
  Guesser(Guess kind, const Placement& placement);

  // A frame that was solved and settled.
  void add(double t, const Vector& settled);
  // The energy must be set to t.
  Start start(double t, ShapeEnergy& energy) const;

 private:
  struct Sample {
    double t;
    Vector positions;
  };
  // `end` is at the time 1, or null.
  Vector continued(double t, std::size_t frames, const Vector* end) const;

  Guess kind_;
  const Placement& placement_;
  std::vector<Sample> last_;  // frames, newest first
};

}  // namespace isostretch::app::interpolate
