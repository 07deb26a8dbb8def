#pragma once

#include "common/guess.hpp"
#include "problem.hpp"

#include <isostretch/core/timer.hpp>
#include <isostretch/newton/solver.hpp>

#include <string>
#include <vector>

namespace isostretch::app::deform {

// What became of one frame.
struct FrameResult {
  newton::Summary summary;  // of all parts of the step together: sums, and the status of the last
  int parts = 0;            // solves; more than one where the handles had to be moved in parts
  double seconds = 0;
  bool reached = false;  // the handles are where they belong at the frame's time
  double time = 0;       // at which `positions` are
  std::string why;       // not reached: the reason
};

// Moves a body along, frame by frame.
class Stepper {
 public:
  Stepper(const Scene& scene, const Body& body, const Rig& rig, Problem& problem, Warn warn,
          double time_limit);

  // From `positions`, which belong to the frame before, to this frame. Where the guess is outside the domain
  // of the energy, the handles go half the way first, and so on; where even 1/4096 of the way is, the
  // frame is not reached and the reason names the element. Ctrl-C and the time limit end it after an
  // iteration.
  FrameResult advance(int frame, Vector& positions);

 private:
  bool solve_part(int frame, double time, Vector& positions, FrameResult& result);
  double time_within(int frame, double way) const;
  std::string obstacle(int frame, const Vector& guess) const;
  std::string overflow(const StrainField& strain) const;

  const Scene& scene_;
  const Body& body_;
  const Rig& rig_;
  Problem& problem_;
  newton::Solver solver_;
  Guesser guesser_;
  Strain strain_;
  double time_limit_;
  Timer timer_;
};

}  // namespace isostretch::app::deform
