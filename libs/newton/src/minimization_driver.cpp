#include <isostretch/newton/minimization_driver.hpp>

#include <cmath>

namespace isostretch::newton {

MinimizationDriver::MinimizationDriver(Summary& summary, const Options& options,
                                       const IterationCallback& callback)
    : IterationDriver(summary, callback, options.stop, Status::stopped_by_callback),
      summary_(summary),
      options_(options) {}

bool MinimizationDriver::begin(const Vector& x) {
  return x.allFinite() || end(Status::failed_start, "the start has positions that are not finite");
}

bool MinimizationDriver::begin(const Evaluation& start) {
  summary_.initial_energy = summary_.energy = start.value;
  if (std::isfinite(start.value)) return true;
  std::string message = "the energy is not finite at the start";
  if (start.worst_element >= 0) message += ": first at element " + std::to_string(start.worst_element);
  return end(Status::failed_start, message);
}

bool MinimizationDriver::record(Iteration row, const Vector& x, double energy, const Vector& gradient) {
  row.energy = summary_.energy = energy;
  row.gradient_inf_norm = summary_.gradient_inf_norm = gradient.size() ? gradient.cwiseAbs().maxCoeff() : 0.0;
  return IterationDriver::record(row, x);
}

bool MinimizationDriver::go_on_with_gradient(int unknowns) {
  if (unknowns == 0) return end(Status::converged_gradient, "every degree of freedom is pinned");
  if (options_.gradient_tolerance > 0 && summary_.gradient_inf_norm <= options_.gradient_tolerance)
    return end(Status::converged_gradient, "|gradient|_inf is within gradient_tolerance");
  return true;
}

bool MinimizationDriver::go_on_with_slope() {
  return summary_.gradient_inf_norm != 0 || end(Status::converged_gradient, "the gradient is zero");
}

bool MinimizationDriver::go_on_within_limits() {
  switch (limit_reached(options_.max_iterations, options_.time_limit)) {
    case SolveStatus::iteration_limit:
      return end(Status::stopped_iterations, "the limit of iterations is reached");
    case SolveStatus::time_limit:
      return end(Status::stopped_time, "the limit of time is reached");
    default:
      return true;
  }
}

void MinimizationDriver::finish(const sparse::Solver* linear) {
  summary_.seconds.total = seconds();
  if (linear == nullptr) return;
  const sparse::Statistics& statistics = linear->statistics();
  summary_.solver = sparse::backend_name(statistics.backend);
  if (statistics.backend == sparse::Backend::pcg)
    summary_.solver.append(" ").append(sparse::preconditioner_name(statistics.preconditioner));
  else if (statistics.ordering != sparse::Ordering::automatic)  // or it has none
    summary_.solver.append(" ").append(sparse::ordering_name(statistics.ordering));
  summary_.factor_nonzeros = statistics.factor_nonzeros;
}

}  // namespace isostretch::newton
