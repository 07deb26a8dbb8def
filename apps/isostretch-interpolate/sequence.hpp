#pragma once

#include "guess.hpp"
#include "options.hpp"
#include "placement.hpp"
#include "shape_energy.hpp"

#include <isostretch/core/timer.hpp>
#include <isostretch/newton/solver.hpp>

#include <array>
#include <string>

namespace isostretch::app::interpolate {

// One frame, the poses at both ends included, which nothing is solved for.
struct Frame {
  int number = 0;
  double time = 0;
  bool solved = true;       // false: a pose
  newton::Summary summary;  // of the solve
  std::string start;        // name of where it began
  double seconds = 0;       // from the start on
  Vector settled;           // the shape; see Placement
  std::array<double, 2> psi;
  double change = 0;      // distance from the frame before, without rigid motion, over the diagonal
  bool complete() const;  // the sequence can go on
};

// Makes frames in their order.
class Interpolator {
 public:
  Interpolator(const Options& options, const Poses& poses, const energies::AnyEnergy& energy);

  // The next one. Ctrl-C and the time limit end it after an iteration.
  Frame next();
  bool done() const { return number_ > options_.frames; }
  // Positions of a frame in its place between the poses. They depend on all frames: call it after the last.
  Vector placed(const Frame& frame) const;

 private:
  Frame pose(Vector settled);
  Frame solved();
  newton::Summary minimize(Vector& positions);
  void measure(Frame& frame);

  const Options& options_;
  Placement placement_;
  ShapeEnergy energy_;
  newton::Solver solver_;
  Guesser guesser_;
  Vector before_;  // the frame before, settled
  double diagonal_;
  int number_ = 0;
  Timer timer_;
};

}  // namespace isostretch::app::interpolate
