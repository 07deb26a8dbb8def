#include "sequence.hpp"

#include "common/interrupt.hpp"
#include "common/newton_report.hpp"
#include "common/terminal.hpp"

#include <isostretch/core/text.hpp>
#include <isostretch/newton/solver.hpp>

#include <algorithm>
#include <utility>

namespace isostretch::app::interpolate {

bool Frame::complete() const {
  return !solved || summary.converged() || summary.status == newton::Status::stopped_iterations;
}

Interpolator::Interpolator(const Options& options, const Poses& poses, const energies::AnyEnergy& energy)
    : options_(options),
      placement_(poses),
      energy_(poses, energy, placement_.loose_nodes()),
      solver_(energy_.objective(), options.newton),
      guesser_(options.guess, placement_),
      before_(placement_.first()),
      diagonal_(poses.first.diagonal()) {}

Frame Interpolator::next() {
  Frame frame = number_ == 0                 ? pose(placement_.first())
                : number_ == options_.frames ? pose(placement_.second_near(before_))
                                             : solved();
  measure(frame);
  ++number_;
  return frame;
}

Vector Interpolator::placed(const Frame& frame) const {
  return placement_.placed(frame.time, frame.settled, placement_.turns(before_));
}

Frame Interpolator::pose(Vector settled) {
  Frame frame;
  frame.number = number_;
  frame.time = options_.time(number_);
  frame.solved = false;
  frame.settled = std::move(settled);
  return frame;
}

Frame Interpolator::solved() {
  const Timer timer;
  Frame frame;
  frame.number = number_;
  frame.time = options_.time(number_);
  energy_.set_time(frame.time);
  Start start = guesser_.start(frame.time, energy_);
  frame.start = start.name;
  frame.summary = minimize(start.positions);
  frame.settled = placement_.settled(std::move(start.positions), before_);
  guesser_.add(frame.time, frame.settled);
  frame.seconds = timer.seconds();
  return frame;
}

newton::Summary Interpolator::minimize(Vector& positions) {
  newton::Options options = options_.newton;
  // What is left; a frame that has no time left still says so after its start.
  if (options.time_limit > 0) options.time_limit = std::max(options.time_limit - timer_.seconds(), 1e-9);
  solver_.set_options(options);
  newton::Summary summary = solver_.solve(positions, [&](const newton::Iteration& row, const Vector&) {
    show_progress(formatted("frame %d of %d  ", number_, options_.frames) + progress_line(row));
    return interrupted() ? newton::CallbackAction::stop : newton::CallbackAction::proceed;
  });
  clear_progress();
  if (summary.status == newton::Status::stopped_by_callback) summary.message = "interrupted (Ctrl-C)";
  log_debug(formatted("frame %d: ", number_) + summary.brief_report());
  return summary;
}

void Interpolator::measure(Frame& frame) {
  frame.psi = energy_.parts(frame.settled);
  frame.change = placement_.distance(frame.settled, before_) / diagonal_;
  before_ = frame.settled;
}

}  // namespace isostretch::app::interpolate
