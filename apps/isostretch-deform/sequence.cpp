#include "sequence.hpp"

#include "common/interrupt.hpp"
#include "common/newton_report.hpp"
#include "common/terminal.hpp"

#include <isostretch/core/text.hpp>
#include <isostretch/newton/solver.hpp>

#include <algorithm>
#include <utility>

namespace isostretch::app::deform {
namespace {

constexpr double least_part = 1.0 / 4096;

// `whole` goes on with `part`.
void append(newton::Summary& whole, newton::Summary part, bool first) {
  if (first) {
    whole = std::move(part);
    return;
  }
  const double before = whole.seconds.total;
  for (newton::Iteration& row : part.trace) {
    row.seconds += before;
    whole.trace.push_back(row);
  }
  whole.status = part.status;
  whole.message = part.message;
  whole.iterations += part.iterations;
  whole.factorizations += part.factorizations;
  whole.failed_factorizations += part.failed_factorizations;
  whole.energy_evaluations += part.energy_evaluations;
  whole.energy = part.energy;
  whole.gradient_inf_norm = part.gradient_inf_norm;
  newton::Seconds& s = whole.seconds;
  const newton::Seconds& p = part.seconds;
  s.total += p.total, s.setup += p.setup, s.assembly += p.assembly;
  s.factorization += p.factorization, s.solve += p.solve, s.line_search += p.line_search;
}

}  // namespace

Stepper::Stepper(const Scene& scene, const Body& body, const Rig& rig, Problem& problem, Warn warn,
                 double time_limit)
    : scene_(scene),
      body_(body),
      rig_(rig),
      problem_(problem),
      solver_(problem.objective(), scene.newton),
      guesser_(scene.guess, body, rig, std::move(warn)),
      strain_(body.elements),
      time_limit_(time_limit) {}

FrameResult Stepper::advance(int frame, Vector& positions) {
  const Timer timer;
  FrameResult result;
  double done = 0, part = 1;  // of the way
  while (done < 1) {
    const double next = std::min(done + part, 1.0);
    const auto at = [&](double way) { return time_within(frame, way); };
    Vector x = guesser_.guess(positions, at(done), at(next), next < 1 || done > 0);
    problem_.set_time(at(next));
    if (!problem_.admissible(x)) {
      part /= 2;
      if (part >= least_part) continue;
      result.why = obstacle(frame, x);
      break;
    }
    const bool on = solve_part(frame, at(next), x, result);
    positions = std::move(x);
    done = next;
    result.time = std::max(at(done), scene_.script.start);  // times before are none of the scene's
    result.reached = on && done == 1;
    if (!on) break;
    part *= 2;
  }
  clear_progress();
  result.seconds = timer.seconds();
  return result;
}

// Where handles begin elsewhere than at rest, half of the first frame takes them there.
double Stepper::time_within(int frame, double way) const {
  double from = scene_.script.time(frame - 1), to = scene_.script.time(frame);
  if (way == 1) return to;
  if (frame == 1 && rig_.comes_from_rest()) {
    if (way < 0.5) to = from, from = scene_.script.rest_time();
    way = way < 0.5 ? 2 * way : 2 * way - 1;
  }
  return from + way * (to - from);
}

bool Stepper::solve_part(int frame, double time, Vector& positions, FrameResult& result) {
  newton::Options options = scene_.newton;
  // What is left; a frame that has no time left still says so after its start.
  if (time_limit_ > 0) options.time_limit = std::max(time_limit_ - timer_.seconds(), 1e-9);
  solver_.set_options(options);
  newton::Summary summary = solver_.solve(positions, [&](const newton::Iteration& row, const Vector&) {
    show_progress(formatted("frame %d of %d  ", frame, scene_.script.frames) + progress_line(row));
    return interrupted() ? newton::CallbackAction::stop : newton::CallbackAction::proceed;
  });
  if (summary.status == newton::Status::stopped_by_callback) summary.message = "interrupted (Ctrl-C)";
  const bool on = summary.converged() || summary.status == newton::Status::stopped_iterations;
  append(result.summary, std::move(summary), result.parts++ == 0);
  log_debug(formatted("frame %d, time %g: ", frame, time) + result.summary.brief_report());
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

}  // namespace isostretch::app::deform
