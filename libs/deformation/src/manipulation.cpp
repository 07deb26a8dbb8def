#include <isostretch/core/error.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/core/timer.hpp>
#include <isostretch/deformation/manipulation.hpp>
#include <isostretch/handles/elements.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace isostretch::deformation {
namespace {

sdp_penalty::Options solver_options(const ManipulationOptions& options, const Monitor& monitor) {
  sdp_penalty::Options solver = options.solver;
  solver.stop = monitor.stop;
  return solver;
}

}  // namespace

std::string progress_line(const sdp_penalty::Iteration& row) {
  return formatted("iteration %d  energy %.6g  bound %.6g  inverted %d  %.1f s", row.iteration, row.energy,
                   row.lower_bound, row.inverted, row.seconds);
}

Manipulation::Manipulation(const ManipulationOptions& options, const SolidModel& body,
                           const HandleSet& handle_set, const ElementRotations& rotations,
                           const Monitor& monitor)
    : options_(options),
      body_(body),
      handle_set_(handle_set),
      rotations_(rotations),
      monitor_(monitor),
      rest_(body.rest_positions()),
      solver_(solver_options(options, monitor)) {
  find_loose_nodes();
  problem_.elements = body.elements;
  problem_.weights = options.weights == ElementWeights::volume ? sdp_penalty::volume_weights(body.elements)
                                                               : sdp_penalty::unit_weights(body.elements);
  // As if the body had a diagonal of length 1: the elastic term does not depend on lengths.
  const double unit = options.units == LengthUnit::diagonal ? body.diagonal() : 1;
  problem_.alpha = options.alpha / unit / unit;
  problem_.incompressibility = options.incompressibility;
  problem_.margin = options.margin;
  problem_.largest_stretch = options.largest_stretch;
}

// A vertex of no element is loose, too, unless it is in a handle.
void Manipulation::find_loose_nodes() {
  const std::vector<int> component = handles::component_of_nodes(body_.elements), own = handle_set_.nodes();
  std::set<int> held, fixed;
  for (const int node : own) held.insert(component[static_cast<std::size_t>(node)]);
  for (std::size_t n = 0; n < component.size(); ++n) {
    const int node = static_cast<int>(n), number = component[n];
    if (number >= 0 ? held.contains(number) : std::binary_search(own.begin(), own.end(), node)) continue;
    loose_nodes_.push_back(node);
    if (number < 0 || fixed.insert(number).second) loose_holds_.push_back(node);
  }
}

void Manipulation::place_targets(double time) {
  problem_.targets.clear();
  const auto add = [&](int node, const handles::Point& place, bool hard) {
    problem_.targets.push_back({node, {place.data(), place.data() + body_.dim}, hard});
  };
  for (const Handle& handle : handle_set_.handles())
    for (const int node : handle.nodes) add(node, handle_set_.target(handle, node, time), !handle.soft);
  for (const int node : loose_holds_) add(node, body_.nodes.row(node).transpose(), true);
}

const sdp_penalty::Problem& Manipulation::prepare(ManipulationFrame& frame) {
  frame.time = options_.script.time(frame.frame);
  frame.given = rotations_.at(frame.time);
  place_targets(frame.time);
  problem_.rotations = frame.rotations = frame.given;
  return problem_;
}

ManipulationFrame Manipulation::solve(int frame) {
  ManipulationFrame result;
  result.frame = frame;
  const Timer timer;
  try {
    prepare(result);
    run(result);
  } catch (const Error& error) {
    result.trouble = error.what();
  }
  result.seconds = timer.seconds();
  return result;
}

void Manipulation::run(ManipulationFrame& result) {
  result.summary =
      solver_.solve(problem_, result.positions, [&](const sdp_penalty::Iteration& row, const Vector& x) {
        if (row.iteration == 0) result.before = x;
        result.path.add(row, x);
        monitor_.show(formatted("frame %d of %d  ", result.frame, options_.script.frames) +
                      progress_line(row));
        return CallbackAction::proceed;
      });
  if (result.summary.status == sdp_penalty::Status::callback) result.summary.message = stop_reason();
  if (!std::isfinite(result.summary.energy) || !result.positions.allFinite() ||
      result.positions.size() != rest_.size())
    result.trouble = result.summary.message;
  else if (result.before.size() == 0)
    result.before = result.positions;
  if (!result.made()) return;
  if (options_.relinearize > 0 && result.summary.status != sdp_penalty::Status::callback) relinearize(result);
  put_loose_nodes_back(result.before);
  put_loose_nodes_back(result.positions);
}

Vector Manipulation::unconstrained() const {
  sdp_penalty::Options options;
  options.method = sdp_penalty::Method::unconstrained;
  options.solver = options_.solver.solver;
  Vector x;
  sdp_penalty::solve(problem_, x, options);
  return x;
}

// Goes on from the result, or from the penalty solution where there is no feasible one. What is reported is
// the last round's convex problem.
void Manipulation::relinearize(ManipulationFrame& result) {
  if (result.summary.feasible())
    problem_.rotations = sdp_penalty::nearest_rotations(problem_.elements, result.positions);
  sdp_penalty::RelinearizeOptions options;
  options.solve = options_.solver;  // without the token: a round that is broken off may lose a feasible x
  options.max_rounds = options_.relinearize;
  sdp_penalty::RelinearizeSummary rounds = sdp_penalty::solve_relinearized(
      problem_, result.positions, options, [&](const sdp_penalty::RelinearizeRound& round, const Vector&) {
        monitor_.show(formatted("frame %d of %d  re-linearised  energy %.6g  inverted %d", result.frame,
                                options_.script.frames, round.energy, round.inverted));
        return monitor_.stop.should_stop() ? CallbackAction::stop : CallbackAction::proceed;
      });
  rounds.last.linear_solves = result.summary.linear_solves;
  rounds.last.iterations = result.summary.iterations;
  for (const sdp_penalty::RelinearizeRound& round : rounds.rounds) {
    rounds.last.linear_solves += round.linear_solves;
    rounds.last.iterations += round.iterations;
  }
  rounds.last.trace = std::move(result.summary.trace);
  result.summary = std::move(rounds.last);
  if (rounds.stopped) {
    result.summary.status = sdp_penalty::Status::callback;
    result.summary.message = stop_reason();
  } else if (!rounds.settled && result.summary.status == sdp_penalty::Status::optimal) {
    result.summary.status = sdp_penalty::Status::iterations;
    result.summary.message = "the rotations have not settled within the rounds of relinearize";
  }
  result.rounds = std::move(rounds.rounds);
  result.rotations = std::move(rounds.rotations);
}

// Where a solve is whole they are there already, but for rounding.
void Manipulation::put_loose_nodes_back(Vector& positions) const {
  for (const int node : loose_nodes_)
    positions.segment(body_.dim * node, body_.dim) = rest_.segment(body_.dim * node, body_.dim);
}

std::string Manipulation::stop_reason() const {
  return monitor_.stop.stop_requested() ? "interrupted" : "the limit of time is reached";
}

}  // namespace isostretch::deformation
