#include "frame_solver.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/log.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/core/timer.hpp>
#include <isostretch/deformation/interpolation.hpp>
#include <isostretch/newton/solver.hpp>

#include <utility>

namespace isostretch::deformation {

namespace {

const InterpolationOptions& checked(const InterpolationOptions& options) {
  if (options.frames < 1) throw OptionError("frames", "must be 1 at least");
  return options;
}

// Anything else would be read beyond its end, or not lead from shape to shape.
const KeyShapes& checked(const KeyShapes& shapes, const energies::AnyEnergy& energy) {
  require_pair(shapes, "the first shape", "the second shape");
  require_least_at_rest(energy, shapes.first.dim);
  return shapes;
}

}  // namespace

bool InterpolationFrame::complete() const {
  return !solved || summary.converged() || summary.status == newton::Status::stopped_iterations;
}

Interpolation::Interpolation(const InterpolationOptions& options, const KeyShapes& key_shapes,
                             const energies::AnyEnergy& energy, const Monitor& monitor)
    : options_(checked(options)),
      monitor_(monitor.with_time_limit(options.newton.time_limit)),
      placement_(checked(key_shapes, energy)),
      energy_(key_shapes, energy, placement_.loose_nodes()),
      solver_(energy_.objective(), options_of_frame(options.newton, monitor_)),
      starts_(options.guess, placement_),
      before_(placement_.first()),
      diagonal_(key_shapes.first.diagonal()) {}

InterpolationFrame Interpolation::next() {
  InterpolationFrame frame = number_ == 0                 ? key_frame(placement_.first())
                             : number_ == options_.frames ? key_frame(placement_.second_near(before_))
                                                          : solved();
  measure(frame);
  ++number_;
  return frame;
}

Vector Interpolation::placed(const InterpolationFrame& frame) const {
  return placement_.placed(frame.time, frame.settled, placement_.rotations_to_second(before_));
}

InterpolationFrame Interpolation::key_frame(Vector settled) {
  InterpolationFrame frame;
  frame.number = number_;
  frame.time = options_.time(number_);
  frame.solved = false;
  frame.settled = std::move(settled);
  return frame;
}

InterpolationFrame Interpolation::solved() {
  const Timer timer;
  InterpolationFrame frame;
  frame.number = number_;
  frame.time = options_.time(number_);
  energy_.set_time(frame.time);
  FrameStart start = starts_.start(frame.time, energy_);
  frame.start = start.name;
  frame.summary = minimize(start.positions);
  frame.settled = placement_.settled(std::move(start.positions), before_);
  starts_.add(frame.time, frame.settled);
  frame.seconds = timer.seconds();
  return frame;
}

newton::Summary Interpolation::minimize(Vector& positions) {
  newton::Summary summary = solver_.solve(positions, [&](const newton::Iteration& row, const Vector&) {
    monitor_.show(formatted("frame %d of %d  ", number_, options_.frames) + newton::progress_line(row));
    return newton::CallbackAction::proceed;
  });
  log(LogLevel::debug, formatted("frame %d: ", number_) + summary.brief_report());
  return summary;
}

void Interpolation::measure(InterpolationFrame& frame) {
  frame.psi = energy_.parts(frame.settled);
  frame.change = placement_.distance(frame.settled, before_) / diagonal_;
  before_ = frame.settled;
}

}  // namespace isostretch::deformation
