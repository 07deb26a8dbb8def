#include "newton_driver.hpp"

#include <memory>
#include <utility>

namespace isostretch::baselines {

newton::Objective objective_of(const DistortionProblem& problem, std::unique_ptr<newton::Term> term) {
  newton::Objective objective(problem.elements.dim, problem.elements.node_count);
  objective.add_term(std::move(term));
  for (const int node : problem.pinned) objective.pin(node);
  return objective;
}

newton::Objective objective_of(const DistortionProblem& problem) {
  return objective_of(problem, std::make_unique<newton::EnergyTerm>(problem.elements, problem.energy));
}

newton::Options shared_options(const MethodOptions& options) {
  newton::Options shared;
  shared.gradient_tolerance = options.gradient_tolerance;
  shared.scaled_gradient_tolerance = 0;
  shared.max_iterations = options.max_iterations;
  shared.time_limit = options.time_limit;
  shared.max_expansion = 1;
  return shared;
}

newton::Summary minimize_since(const Timer& timer, newton::Objective& objective, Vector& x,
                               const newton::Options& options, const newton::IterationCallback& callback) {
  const double before = timer.seconds();
  newton::Summary summary = newton::minimize(objective, x, options, callback);
  summary.seconds.setup += before;
  summary.seconds.total += before;
  for (newton::Iteration& row : summary.trace) row.seconds += before;
  return summary;
}

newton::Summary minimize_with(const Timer& timer, std::unique_ptr<newton::Term> term,
                              const DistortionProblem& problem, Vector& x, const MethodOptions& options,
                              const newton::IterationCallback& callback) {
  newton::Objective objective = objective_of(problem, std::move(term));
  newton::Options shared = shared_options(options);
  shared.projection = newton::Projection::none;
  return minimize_since(timer, objective, x, shared, callback);
}

}  // namespace isostretch::baselines
