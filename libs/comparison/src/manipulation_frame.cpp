#include "memory_limit.hpp"

#include <isostretch/comparison/manipulation_frame.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/core/timer.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace isostretch::comparison {
namespace {

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

FrameSolver::FrameSolver(const deformation::ManipulationOptions& manipulation,
                         const deformation::SolidModel& body, const deformation::HandleSet& handle_set,
                         const deformation::ElementRotations& rotations, const Monitor& monitor,
                         FrameSolverOptions options)
    : scene_(manipulation),
      options_(std::move(options)),
      monitor_(monitor),
      rest_(body.rest_positions()),
      manipulation_(manipulation, body, handle_set, rotations, monitor_) {}

ManipulationFrame FrameSolver::solve(int frame) {
  ManipulationFrame result =
      options_.rival.empty() ? ManipulationFrame{manipulation_.solve(frame)} : solve_by_rival(frame);
  if (result.stopped()) result.summary.message = options_.stop_reason();
  return result;
}

ManipulationFrame FrameSolver::solve_by_rival(int frame) {
  ManipulationFrame result;
  result.frame = frame;
  const Timer timer;
  try {
    run_rival(result);
  } catch (const Error& error) {
    result.trouble = error.what();
  }
  result.seconds = timer.seconds();
  return result;
}

// The limit is the frames' together.
void FrameSolver::run_rival(ManipulationFrame& result) {
  baselines::Options options;
  options.tolerance = scene_.solver.gap_tolerance;
  options.limits.megabytes = options_.memory_limit;
  options.limits.iterations = scene_.solver.max_iterations;
  options.stop = monitor_.stop;
  const sdp_penalty::Problem& problem = manipulation_.prepare(result);
  result.before = manipulation_.unconstrained();
  const auto solve = [&] {
    const MemoryLimit limit(options_.memory_limit);
    return baselines::solve(
        options_.rival, {problem, rest_}, options, [&](const baselines::Point& point, const Vector& x) {
          const sdp_penalty::Iteration row = row_of(point);
          result.path.add(row, x);
          result.summary.trace.push_back(row);
          monitor_.show(formatted("frame %d of %d  ", result.frame, scene_.script.frames) + options_.rival +
                        "  " + deformation::progress_line(row));
          return baselines::CallbackAction::proceed;
        });
  };
  baselines::Result made = solve();
  if (made.status == baselines::Status::callback) made.message = options_.stop_reason();
  if (made.has_positions() && made.x.allFinite()) {
    manipulation_.put_loose_nodes_back(made.x);  // an unfinished run may have moved them
    made.measures = baselines::measure(problem, made.x);
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
        options_.rival + ": " + std::string(baselines::status_name(made.status)) + ", " + made.message;
  result.rival = std::move(made);
  if (!result.made()) return;
  manipulation_.put_loose_nodes_back(result.before);
}

}  // namespace isostretch::comparison
