#include "frame.hpp"

#include "common/memory_limit.hpp"
#include "common/monitor.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/text.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace isostretch::app::manipulate {
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

FrameSolver::FrameSolver(const Scene& scene, const deformation::SolidModel& body,
                         const deformation::HandleSet& handle_set,
                         const deformation::ElementRotations& rotations, const Options& options)
    : scene_(scene),
      options_(options),
      monitor_(terminal_monitor().with_time_limit(options.time_limit)),
      rest_(body.rest_positions()),
      manipulation_(scene, body, handle_set, rotations, monitor_) {}

FrameResult FrameSolver::solve(int frame) {
  FrameResult result = scene_.rival.empty() ? FrameResult{manipulation_.solve(frame)} : solve_by_rival(frame);
  clear_progress();
  if (result.stopped()) result.summary.message = halt();
  return result;
}

FrameResult FrameSolver::solve_by_rival(int frame) {
  FrameResult result;
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
void FrameSolver::run_rival(FrameResult& result) {
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
        scene_.rival, {problem, rest_}, options, [&](const baselines::Point& point, const Vector& x) {
          const sdp_penalty::Iteration row = row_of(point);
          result.path.add(row, x);
          result.summary.trace.push_back(row);
          show_progress(formatted("frame %d of %d  ", result.frame, scene_.script.frames) + scene_.rival +
                        "  " + deformation::progress_line(row));
          return baselines::CallbackAction::proceed;
        });
  };
  baselines::Result made = solve();
  if (made.status == baselines::Status::callback) made.message = halt();
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
        scene_.rival + ": " + std::string(baselines::status_name(made.status)) + ", " + made.message;
  result.rival = std::move(made);
  if (!result.made()) return;
  manipulation_.put_loose_nodes_back(result.before);
}

std::string FrameSolver::halt() const {
  if (monitor_.stop.stop_requested()) return "interrupted (Ctrl-C)";
  if (monitor_.stop.deadline_passed())
    return formatted("stopped after %g seconds (--time-limit)", options_.time_limit);
  return {};
}

}  // namespace isostretch::app::manipulate
