#include "first_order_driver.hpp"

#include "newton_driver.hpp"
#include "shear_modulus.hpp"
#include "stagnation.hpp"

#include <isostretch/core/timer.hpp>
#include <isostretch/newton/minimization_driver.hpp>
#include <isostretch/newton/positions.hpp>

#include <algorithm>
#include <cmath>
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
      : method_(method),
        x_(x),
        options_(shared_options(options)),
        driver_(summary_, options_, callback),
        pieces_(problem, summary_) {}

  newton::Summary run() {
    if (start())
      while (goes_on() && take_step()) {
      }
    if (summary_.status != Status::failed_start) x_.swap(at_.x);
    driver_.finish(pieces_.metric().solver());
    return std::move(summary_);
  }

 private:
  bool start() {
    if (!driver_.begin(x_)) return false;
    at_.x = x_;
    const newton::Evaluation start = pieces_.differentiate(at_.x, at_.gradient);
    at_.energy = start.value;
    if (!driver_.begin(start)) return false;
    if (!at_.gradient.allFinite())
      return driver_.end(Status::failed_start, "the gradient is not finite at the start");
    return driver_.record({}, at_.x, at_.energy, at_.gradient);
  }

  bool goes_on() {
    if (!driver_.go_on_with_gradient(pieces_.metric().unknowns()) || !driver_.go_on_with_slope())
      return false;
    if (stagnation_.found(at_.energy, summary_.gradient_inf_norm, pieces_.noise(at_)))
      return driver_.end(Status::converged_roundoff, "neither energy nor gradient improves any more");
    return driver_.go_on_within_limits();
  }

  bool take_step() {
    if (summary_.factorizations == 0)
      if (const sparse::FactorResult result = pieces_.factorize(); !result)
        return driver_.end(Status::failed_factorization, result.message);
    Step step = counted_step();
    if (!step.taken && method_.restart()) step = counted_step();
    if (!step.taken)
      return step.at_roundoff
                 ? driver_.end(Status::converged_roundoff, "no step lowers the energy beyond its rounding")
                 : driver_.end(Status::failed_line_search, "no step along the direction lowers the energy");
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
      return driver_.end(Status::failed_line_search, "energy or gradient is not finite after a step");
    std::swap(at_, next);
    ++summary_.iterations;
    step.row.factorizations = summary_.iterations == 1 ? summary_.factorizations : 0;
    return driver_.record(step.row, at_.x, at_.energy, at_.gradient);
  }

  FirstOrderMethod& method_;
  Vector& x_;
  newton::Options options_;
  newton::Summary summary_;
  newton::MinimizationDriver driver_;  // before the pieces: the setup counts
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
