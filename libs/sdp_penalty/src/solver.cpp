#include "methods.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/sdp_penalty/solver.hpp>

#include <string>

namespace isostretch::sdp_penalty {

struct Solver::Kept {
  Kept(const Problem& problem, const Options& options) : work(problem, options) {}
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

Summary Solver::solve(const Problem& problem, Vector& x, const IterationCallback& callback) {
  problem.validate();
  if (problem.bounds_stretch() && options_.method != Method::interior_point)
    throw Error("largest_stretch: the method " + std::string(method_name(options_.method)) +
                " does not know it; interior_point does");
  if (kept_ && kept_->work.system.has_structure_of(problem))
    kept_->work.system.bind(problem);
  else
    kept_ = std::make_unique<Kept>(problem, options_);
  Workspace& work = kept_->work;
  Progress progress(work, options_, callback);
  if (work.unconstrained.refresh(work.system)) progress.count_solve();
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
      case Method::skinning:
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
