#include "frame.hpp"

#include "common/interrupt.hpp"
#include "common/memory_limit.hpp"
#include "common/terminal.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/handles/elements.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace isostretch::app::manipulate {
namespace {

std::string progress_line(const sdp_penalty::Iteration& row) {
  return formatted("iteration %d  energy %.6g  bound %.6g  inverted %d  %.1f s", row.iteration, row.energy,
                   row.lower_bound, row.inverted, row.seconds);
}

// What a rival does not know of the row stays unknown.
sdp_penalty::Iteration row_of(const baselines::Point& point) {
  sdp_penalty::Iteration row;
  row.iteration = point.iteration;
  row.seconds = point.seconds;
  row.energy = point.measures.energy;
  row.lower_bound = -std::numeric_limits<double>::infinity();
  row.min_eigenvalue = point.measures.min_eigenvalue;
  row.inverted = point.measures.inverted;
  row.infeasible = point.measures.infeasible;
  return row;
}

}  // namespace

FrameSolver::FrameSolver(const Scene& scene, const Body& body, const Rig& rig,
                         const ElementRotations& rotations, const Options& options)
    : scene_(scene),
      body_(body),
      rig_(rig),
      rotations_(rotations),
      options_(options),
      rest_(body.rest_positions()),
      solver_(scene.solver) {
  find_loose_nodes();
  problem_.elements = body.elements;
  problem_.weights = scene.weights == Weights::volume ? sdp_penalty::volume_weights(body.elements)
                                                      : sdp_penalty::unit_weights(body.elements);
  // As if the body had a diagonal of length 1: the elastic term does not depend on lengths.
  const double unit = scene.units == Units::diagonal ? body.diagonal() : 1;
  problem_.alpha = scene.alpha / unit / unit;
  problem_.incompressibility = scene.incompressibility;
  problem_.margin = scene.margin;
  problem_.largest_stretch = scene.largest_stretch;
}

// A vertex of no element is loose, too, unless it is in a handle.
void FrameSolver::find_loose_nodes() {
  const std::vector<int> component = handles::component_of_nodes(body_.elements), own = rig_.nodes();
  std::set<int> held, fixed;
  for (const int node : own) held.insert(component[static_cast<std::size_t>(node)]);
  for (std::size_t n = 0; n < component.size(); ++n) {
    const int node = static_cast<int>(n), number = component[n];
    if (number >= 0 ? held.contains(number) : std::binary_search(own.begin(), own.end(), node)) continue;
    loose_nodes_.push_back(node);
    if (number < 0 || fixed.insert(number).second) loose_holds_.push_back(node);
  }
}

void FrameSolver::place_targets(double time) {
  problem_.targets.clear();
  const auto add = [&](int node, const handles::Point& place, bool hard) {
    problem_.targets.push_back({node, {place.data(), place.data() + body_.dim}, hard});
  };
  for (const Handle& handle : rig_.handles())
    for (const int node : handle.nodes) add(node, rig_.target(handle, node, time), !handle.soft);
  for (const int node : loose_holds_) add(node, body_.nodes.row(node).transpose(), true);
}

FrameResult FrameSolver::solve(int frame) {
  FrameResult result{frame, scene_.script.time(frame), {}};
  {
    const ScopedTimer timer(result.seconds);
    try {
      result.given = rotations_.at(result.time);
      place_targets(result.time);
      problem_.rotations = result.rotations = result.given;
      if (scene_.rival.empty())
        run(result);
      else
        run_rival(result);
    } catch (const Error& error) {
      result.trouble = error.what();
    }
  }
  clear_progress();
  return result;
}

void FrameSolver::run(FrameResult& result) {
  result.summary =
      solver_.solve(problem_, result.positions, [&](const sdp_penalty::Iteration& row, const Vector& x) {
        if (row.iteration == 0) result.before = x;
        result.path.add(row, x);
        show_progress(formatted("frame %d of %d  ", result.frame, scene_.script.frames) + progress_line(row));
        return halt().empty() ? sdp_penalty::CallbackAction::proceed : sdp_penalty::CallbackAction::stop;
      });
  if (result.summary.status == sdp_penalty::Status::callback) result.summary.message = halt();
  if (!std::isfinite(result.summary.energy) || !result.positions.allFinite() ||
      result.positions.size() != rest_.size())
    result.trouble = result.summary.message;
  else if (result.before.size() == 0)
    result.before = result.positions;
  if (!result.made()) return;
  if (scene_.relinearize > 0 && result.summary.status != sdp_penalty::Status::callback) relinearize(result);
  put_loose_nodes_back(result.before);
  put_loose_nodes_back(result.positions);
}

// The limit is the frames' together.
void FrameSolver::run_rival(FrameResult& result) {
  baselines::Options options;
  options.tolerance = scene_.solver.gap_tolerance;
  options.limits.seconds =
      options_.time_limit > 0 ? std::max(1e-3, options_.time_limit - timer_.seconds()) : 0;
  options.limits.megabytes = options_.memory_limit;
  options.limits.iterations = scene_.solver.max_iterations;
  options.keep_going = [] { return !interrupted(); };
  result.before = skinned();
  const auto solve = [&] {
    const MemoryLimit limit(options_.memory_limit);
    return baselines::solve(
        scene_.rival, {problem_, rest_}, options, [&](const baselines::Point& point, const Vector& x) {
          const sdp_penalty::Iteration row = row_of(point);
          result.path.add(row, x);
          result.summary.trace.push_back(row);
          show_progress(formatted("frame %d of %d  ", result.frame, scene_.script.frames) + scene_.rival +
                        "  " + progress_line(row));
          return baselines::CallbackAction::proceed;
        });
  };
  baselines::Result made = solve();
  if (made.status == baselines::Status::callback) made.message = halt();
  if (made.has_positions() && made.x.allFinite()) {
    put_loose_nodes_back(made.x);  // an unfinished run may have moved them
    made.measures = baselines::measure(problem_, made.x);
  }
  result.summary.message = made.message;
  result.summary.iterations = made.iterations;
  result.summary.linear_solves = made.linear_solves;
  result.summary.energy = made.measures.energy;
  result.summary.target_energy = made.measures.target_energy;
  result.summary.lower_bound = made.lower_bound;
  result.positions = made.x;
  if (!made.has_positions() || !made.x.allFinite())
    result.trouble =
        scene_.rival + ": " + std::string(baselines::status_name(made.status)) + ", " + made.message;
  result.rival = std::move(made);
  if (!result.made()) return;
  put_loose_nodes_back(result.before);
}

// Ex-rotated skinning, which the picture shows beside the result; its time is not the solver's.
Vector FrameSolver::skinned() const {
  sdp_penalty::Options options;
  options.method = sdp_penalty::Method::skinning;
  options.solver = scene_.solver.solver;
  Vector x;
  sdp_penalty::solve(problem_, x, options);
  return x;
}

// Goes on from the result, or from the soft answer where there is no feasible one. What is reported is the
// last round's convex problem.
void FrameSolver::relinearize(FrameResult& result) {
  if (result.summary.feasible())
    problem_.rotations = sdp_penalty::nearest_rotations(problem_.elements, result.positions);
  sdp_penalty::RelinearizeOptions options;
  options.solve = scene_.solver;
  options.max_rounds = scene_.relinearize;
  sdp_penalty::RelinearizeSummary rounds = sdp_penalty::solve_relinearized(
      problem_, result.positions, options, [&](const sdp_penalty::RelinearizeRound& round, const Vector&) {
        show_progress(formatted("frame %d of %d  re-linearised  energy %.6g  inverted %d", result.frame,
                                scene_.script.frames, round.energy, round.inverted));
        return halt().empty() ? sdp_penalty::CallbackAction::proceed : sdp_penalty::CallbackAction::stop;
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
    result.summary.message = halt();
  } else if (!rounds.settled && result.summary.status == sdp_penalty::Status::optimal) {
    result.summary.status = sdp_penalty::Status::iterations;
    result.summary.message = "the rotations have not settled within the rounds of relinearize";
  }
  result.rounds = std::move(rounds.rounds);
  result.rotations = std::move(rounds.rotations);
}

// Where a solve is whole they are there already, but for rounding.
void FrameSolver::put_loose_nodes_back(Vector& positions) const {
  for (const int node : loose_nodes_)
    positions.segment(body_.dim * node, body_.dim) = rest_.segment(body_.dim * node, body_.dim);
}

std::string FrameSolver::halt() const {
  if (interrupted()) return "interrupted (Ctrl-C)";
  if (options_.time_limit > 0 && timer_.seconds() > options_.time_limit)
    return formatted("stopped after %g seconds (--time-limit)", options_.time_limit);
  return {};
}

}  // namespace isostretch::app::manipulate
