#include "first_order_driver.hpp"

#include "newton_driver.hpp"
#include "shear_modulus.hpp"
#include "stagnation.hpp"

#include <isostretch/core/timer.hpp>
#include <isostretch/newton/positions.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace isostretch::baselines {
namespace {

using newton::Status;

}  // namespace

SharedPieces::SharedPieces(const DistortionProblem& problem, newton::Summary& summary)
    : problem_(problem), summary_(summary), stiffness_(shear_at_rest(problem)) {
  const ScopedTimer timer(summary_.seconds.setup);
  objective_ = std::make_unique<newton::Objective>(objective_of(problem));
  metric_ = std::make_unique<DirichletMetric>(problem);
}

double SharedPieces::value(const Vector& x) {
  const ScopedTimer timer(summary_.seconds.line_search);
  return objective_->value(x).value;
}

newton::Evaluation SharedPieces::differentiate(const Vector& x, Vector& gradient) {
  const ScopedTimer timer(summary_.seconds.assembly);
  return objective_->differentiate(x, {}, gradient, false);
}

sparse::FactorResult SharedPieces::factorize() {
  const ScopedTimer timer(summary_.seconds.factorization);
  ++summary_.factorizations;
  sparse::FactorResult result = metric_->factorize();
  if (!result) ++summary_.failed_factorizations;
  return result;
}

void SharedPieces::solve(const Vector& right, Vector& direction) {
  const ScopedTimer timer(summary_.seconds.solve);
  metric_->solve(right, direction);
}

double SharedPieces::noise(const Iterate& at) const {
  constexpr double relative = 2e-14;
  const double length = newton::rounding_length(at.x, problem_.elements.dim);
  return std::max(relative * std::abs(at.energy),
                  metric_->unknowns() * stiffness_ * metric_->typical_stiffness() * length * length);
}

Step search_step(const Iterate& from, const Vector& direction, const newton::Options& options,
                 SharedPieces& pieces) {
  Step step;
  const double slope = from.gradient.dot(direction);
  if (!(slope < 0)) return step;
  const ScopedTimer timer(pieces.seconds().line_search);
  const newton::LineSearchResult search = newton::search_line(
      pieces.objective(), from.x, direction, from.energy, slope, pieces.noise(from), options, step.x);
  step.taken = search.accepted;
  step.at_roundoff = search.at_roundoff;
  step.row.step = search.step;
  step.row.decrement = -0.5 * slope;
  step.row.evaluations = search.evaluations;
  return step;
}

namespace {

// One run, from start to summary.
class FirstOrderDriver {
 public:
  FirstOrderDriver(FirstOrderMethod& method, const DistortionProblem& problem, Vector& x,
                   const MethodOptions& options, const newton::IterationCallback& callback)
      : method_(method), x_(x), options_(options), callback_(callback), pieces_(problem, summary_) {}

  newton::Summary run() {
    if (start())
      while (!stop_before_step() && take_step()) {
      }
    return finish();
  }

 private:
  bool start() {
    if (!x_.allFinite()) return end(Status::failed_start, "the start has positions that are not finite");
    at_.x = x_;
    const newton::Evaluation start = pieces_.differentiate(at_.x, at_.gradient);
    summary_.initial_energy = summary_.energy = at_.energy = start.value;
    if (!std::isfinite(start.value))
      return end(Status::failed_start,
                 "the energy is not finite at the start" +
                     (start.worst_element >= 0 ? ": first at element " + std::to_string(start.worst_element)
                                               : std::string()));
    if (!at_.gradient.allFinite())
      return end(Status::failed_start, "the gradient is not finite at the start");
    return record({});
  }

  bool record(newton::Iteration row) {
    row.iteration = summary_.iterations;
    row.seconds = timer_.seconds();
    row.energy = at_.energy;
    row.gradient_inf_norm = summary_.gradient_inf_norm = at_.gradient.cwiseAbs().maxCoeff();
    summary_.trace.push_back(row);
    if (callback_ && callback_(row, at_.x) == newton::CallbackAction::stop)
      return end(Status::stopped_by_callback, "stopped by the callback");
    return true;
  }

  bool stop_before_step() {
    if (summary_.status != Status::not_run) return true;
    const double norm = summary_.gradient_inf_norm;
    if (pieces_.metric().unknowns() == 0)
      return !end(Status::converged_gradient, "every degree of freedom is pinned");
    if (options_.gradient_tolerance > 0 && norm <= options_.gradient_tolerance)
      return !end(Status::converged_gradient, "|gradient|_inf is within gradient_tolerance");
    if (norm == 0) return !end(Status::converged_gradient, "the gradient is zero");
    if (stagnation_.found(at_.energy, norm, pieces_.noise(at_)))
      return !end(Status::converged_roundoff, "neither energy nor gradient improves any more");
    if (summary_.iterations >= options_.max_iterations)
      return !end(Status::stopped_iterations, "max_iterations reached");
    if (options_.time_limit > 0 && timer_.seconds() >= options_.time_limit)
      return !end(Status::stopped_time, "time_limit reached");
    return false;
  }

  bool take_step() {
    if (summary_.factorizations == 0)
      if (const sparse::FactorResult result = pieces_.factorize(); !result)
        return end(Status::failed_factorization, result.message);
    Step step = counted_step();
    if (!step.taken && method_.restart()) step = counted_step();
    if (!step.taken)
      return step.at_roundoff
                 ? end(Status::converged_roundoff, "no step lowers the energy beyond its rounding")
                 : end(Status::failed_line_search, "no step along the direction lowers the energy");
    return accept(std::move(step));
  }

  Step counted_step() {
    Step step = method_.step(at_, pieces_);
    summary_.energy_evaluations += step.row.evaluations;
    return step;
  }

  bool accept(Step step) {
    Iterate next;
    next.x.swap(step.x);
    next.energy = pieces_.differentiate(next.x, next.gradient).value;
    if (!std::isfinite(next.energy) || !next.gradient.allFinite())
      return end(Status::failed_line_search, "energy or gradient is not finite after a step");
    std::swap(at_, next);
    summary_.energy = at_.energy;
    ++summary_.iterations;
    step.row.factorizations = summary_.iterations == 1 ? summary_.factorizations : 0;
    return record(step.row);
  }

  bool end(Status status, std::string message) {
    summary_.status = status;
    summary_.message = std::move(message);
    return false;
  }

  newton::Summary finish() {
    if (summary_.status != Status::failed_start) x_.swap(at_.x);
    summary_.seconds.total = timer_.seconds();
    if (const sparse::Solver* solver = pieces_.metric().solver()) {
      const sparse::Statistics& statistics = solver->statistics();
      summary_.solver = std::string(sparse::backend_name(statistics.backend)) + " " +
                        std::string(sparse::ordering_name(statistics.ordering));
      summary_.factor_nonzeros = statistics.factor_nonzeros;
    }
    return std::move(summary_);
  }

  Timer timer_;  // first: the setup counts
  FirstOrderMethod& method_;
  Vector& x_;
  const MethodOptions& options_;
  const newton::IterationCallback& callback_;
  newton::Summary summary_;
  SharedPieces pieces_;
  Stagnation stagnation_;
  Iterate at_;
};

}  // namespace

newton::Summary minimize_first_order(FirstOrderMethod& method, const DistortionProblem& problem, Vector& x,
                                     const MethodOptions& options,
                                     const newton::IterationCallback& callback) {
  return FirstOrderDriver(method, problem, x, options, callback).run();
}

}  // namespace isostretch::baselines
