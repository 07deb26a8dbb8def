#include "frame_solver.hpp"

#include <isostretch/core/log.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/core/timer.hpp>
#include <isostretch/deformation/sequence.hpp>
#include <isostretch/newton/solver.hpp>

#include <algorithm>
#include <utility>

namespace isostretch::deformation {
namespace {

constexpr double least_part = 1.0 / 4096;

// `whole` goes on with `part`.
void append(newton::Summary& whole, newton::Summary part, bool first) {
  if (first) {
    whole = std::move(part);
    return;
  }
  for (newton::Iteration& row : part.trace) {
    row.seconds += whole.seconds.total;
    whole.trace.push_back(row);
  }
  whole.add_effort(part);
  whole.status = part.status;
  whole.message = part.message;
  whole.energy = part.energy;
  whole.gradient_inf_norm = part.gradient_inf_norm;
}

}  // namespace

Stepper::Stepper(const SequenceOptions& options, const SolidModel& body, const HandleSet& handle_set,
                 ElasticProblem& problem, Warn warn, const Monitor& monitor)
    : options_(options),
      body_(body),
      handle_set_(handle_set),
      problem_(problem),
      monitor_(monitor.with_time_limit(options.newton.time_limit)),
      solver_(problem.objective(), options_of_frame(options.newton, monitor_)),
      predictor_(options.guess, body, handle_set, std::move(warn)),
      strain_(body.elements) {}

FrameResult Stepper::advance(int frame, Vector& positions) {
  const Timer timer;
  FrameResult result;
  double done = 0, part = 1;  // of the way
  while (done < 1) {
    const double next = std::min(done + part, 1.0);
    const auto at = [&](double way) { return time_within(frame, way); };
    Vector x = predictor_.guess(positions, at(done), at(next), next < 1 || done > 0);
    problem_.set_time(at(next));
    if (!problem_.feasible(x)) {
      part /= 2;
      if (part >= least_part) continue;
      result.why = obstacle(frame, x);
      break;
    }
    const bool on = solve_part(frame, at(next), x, result);
    positions = std::move(x);
    done = next;
    result.time = std::max(at(done), options_.script.start);  // times before are none of the scene's
    result.reached = on && done == 1;
    if (!on) break;
    part *= 2;
  }
  result.seconds = timer.seconds();
  return result;
}

// Where handles begin elsewhere than at rest, half of the first frame takes them there.
double Stepper::time_within(int frame, double way) const {
  double from = options_.script.time(frame - 1), to = options_.script.time(frame);
  if (way == 1) return to;
  if (frame == 1 && handle_set_.comes_from_rest()) {
    if (way < 0.5) to = from, from = options_.script.rest_time();
    way = way < 0.5 ? 2 * way : 2 * way - 1;
  }
  return from + way * (to - from);
}

bool Stepper::solve_part(int frame, double time, Vector& positions, FrameResult& result) {
  newton::Summary summary = solver_.solve(positions, [&](const newton::Iteration& row, const Vector&) {
    monitor_.show(formatted("frame %d of %d  ", frame, options_.script.frames) + newton::progress_line(row));
    return newton::CallbackAction::proceed;
  });
  const bool on = summary.converged() || summary.status == newton::Status::stopped_iterations;
  append(result.summary, std::move(summary), result.parts++ == 0);
  log(LogLevel::debug, formatted("frame %d, time %g: ", frame, time) + result.summary.brief_report());
  return on;
}

std::string Stepper::obstacle(int frame, const Vector& guess) const {
  const StrainField strain = strain_.at(guess);
  const int element = strain.worst_element();
  if (strain.smallest_det() > 0) return formatted("frame %d: ", frame) + overflow(strain);
  return formatted(
             "frame %d: the handles cannot move on without inverting an element, however small the step: ",
             frame) +
         body_.element_text(element) + formatted(" gets det F = %.3g", strain.smallest_det());
}

// Nothing is inverted, and yet the energy is not finite.
std::string Stepper::overflow(const StrainField& strain) const {
  const auto& change = strain.length_change;
  const auto worst = std::max_element(change.begin(), change.end());
  return "the energy is not finite, however small the step: " +
         body_.element_text(static_cast<int>(worst - change.begin())) +
         formatted(" changes a length by a factor of %.3g", *worst);
}

// In one place, for they refer to each other.
struct Sequence::Parts {
  Parts(SequenceOptions given, SolidModel solid, const Monitor& monitor)
      : options(checked(std::move(given))),
        body(std::move(solid)),
        handle_set(options.script, body),
        problem(options, body, handle_set),
        stepper(
            options, body, handle_set, problem, [](const std::string& text) { log(LogLevel::warning, text); },
            monitor),
        positions(body.rest_positions()) {}

  static SequenceOptions checked(SequenceOptions given) {
    if (given.script.frames < 1) throw OptionError("frames", "must be 1 at least");
    return given;
  }

  SequenceOptions options;
  SolidModel body;
  HandleSet handle_set;
  ElasticProblem problem;
  Stepper stepper;
  Vector positions;
  int frame = 0;
  bool stuck = false;
};

Sequence::Sequence(SequenceOptions options, SolidModel body, const Monitor& monitor)
    : parts_(std::make_unique<Parts>(std::move(options), std::move(body), monitor)) {}
Sequence::~Sequence() = default;
Sequence::Sequence(Sequence&&) noexcept = default;
Sequence& Sequence::operator=(Sequence&&) noexcept = default;

bool Sequence::done() const {
  return parts_->stuck || parts_->frame == parts_->options.script.frames;
}

FrameResult Sequence::next() {
  if (done()) throw Error(ErrorKind::misuse, "deformation sequence: there is no frame left to make");
  FrameResult result = parts_->stepper.advance(++parts_->frame, parts_->positions);
  parts_->stuck = !result.reached;
  return result;
}

int Sequence::frame() const {
  return parts_->frame;
}
const Vector& Sequence::positions() const {
  return parts_->positions;
}
const SolidModel& Sequence::body() const {
  return parts_->body;
}

}  // namespace isostretch::deformation
