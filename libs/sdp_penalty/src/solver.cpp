#include "methods.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/log.hpp>
#include <isostretch/sdp_penalty/solver.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace isostretch::sdp_penalty {

struct Solver::State {
  State(const Problem& problem, const Options& options) : work(problem, options) {}
  Workspace work;
};

Solver::Solver(const Options& options) : options_(options) {
  options_.validate();
  if (options_.max_iterations == 0)
    options_.max_iterations = options_.method == Method::interior_point ? 60 : 2000;
}

Solver::~Solver() = default;
Solver::Solver(Solver&&) noexcept = default;
Solver& Solver::operator=(Solver&&) noexcept = default;

namespace {

// The middle of the targets, where the body is farther from the origin than ten times its size: there F loses
// digits that the constraint needs. Nothing depends on where the body is, so that it can be moved. Empty
// otherwise.
std::vector<double> far_away(const Problem& problem) {
  std::vector<double> middle;
  const auto dim = static_cast<std::size_t>(problem.dim());
  double extent = 0, distance = 0;
  for (std::size_t r = 0; r < dim; ++r) {
    double low = problem.targets[0].position[r], high = low;
    for (const Target& target : problem.targets) {
      low = std::min(low, target.position[r]);
      high = std::max(high, target.position[r]);
    }
    middle.push_back(0.5 * low + 0.5 * high);
    extent = std::max(extent, high - low);
    distance = std::max(distance, std::abs(middle.back()));
  }
  return distance > 10 * extent && distance > 0 ? middle : std::vector<double>();
}

void move(Vector& x, const std::vector<double>& by, double sign) {
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] += sign * by[static_cast<std::size_t>(i) % by.size()];
}

}  // namespace

Summary Solver::solve(const Problem& problem, Vector& x, const IterationCallback& callback) {
  problem.validate();
  const std::vector<double> middle = far_away(problem);
  if (middle.empty()) return solve_here(problem, x, callback);
  Problem moved = problem;
  for (Target& target : moved.targets)
    for (std::size_t r = 0; r < middle.size(); ++r) target.position[r] -= middle[r];
  IterationCallback seen;
  if (callback)
    seen = [&](const Iteration& row, const Vector& positions) {
      Vector back = positions;
      move(back, middle, 1);
      return callback(row, back);
    };
  const Summary summary = solve_here(moved, x, seen);
  move(x, middle, 1);
  return summary;
}

Summary Solver::solve_here(const Problem& problem, Vector& x, const IterationCallback& callback) {
  if (problem.bounds_stretch() && options_.method != Method::interior_point)
    throw Error("largest_stretch: the method " + std::string(method_name(options_.method)) +
                " does not know it; interior_point does");
  if (state_ && state_->work.system.has_structure_of(problem))
    state_->work.system.set_problem(problem);
  else
    state_ = std::make_unique<State>(problem, options_);
  Workspace& work = state_->work;
  Progress progress(work, options_, callback);
  if (work.unconstrained.refresh(work.system)) progress.count_solve();
  log(LogLevel::debug, [&] {
    return "sdp_penalty: " + std::string(method_name(options_.method)) + " on " +
           std::to_string(problem.element_count()) + " elements, " + std::to_string(problem.targets.size()) +
           " targets";
  });
  x = work.unconstrained.minimiser();
  const Constrained at_start = work.system.constrained(x);
  progress.record({}, x, at_start,
                  {Blocks(at_start.orientation.size(), 0.0), Blocks(at_start.stretch.size(), 0.0)});
  if (!progress.ended()) {
    switch (options_.method) {
      case Method::interior_point:
        interior_point(work, options_, progress, x);
        break;
      case Method::penalty:
        penalty_path(work, options_, progress, x);
        break;
      case Method::augmented_lagrangian:
        augmented_lagrangian(work, options_, progress, x);
        break;
      case Method::spectral_sdp:
        spectral_sdp(work, options_, progress, x);
        break;
      case Method::pennon:
        pennon(work, options_, progress, x);
        break;
      case Method::unconstrained:
        progress.end(Status::path_end, "the minimiser without constraints");
        break;
    }
  }
  return progress.finish(x);
}

Summary solve(const Problem& problem, Vector& x, const Options& options, const IterationCallback& callback) {
  return Solver(options).solve(problem, x, callback);
}

}  // namespace isostretch::sdp_penalty
