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

newton::Summary minimize_with(std::unique_ptr<newton::Term> term, const DistortionProblem& problem, Vector& x,
                              const MethodOptions& options, const newton::IterationCallback& callback) {
  newton::Objective objective = objective_of(problem, std::move(term));
  newton::Options shared = shared_options(options);
  shared.projection = newton::Projection::none;
  return newton::minimize(objective, x, shared, callback);
}

}  // namespace isostretch::baselines
