#include "bcqn.hpp"

#include "method_registry.hpp"

#include <isostretch/core/timer.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace isostretch::baselines {
namespace {

newton::Options search_options() {
  newton::Options options;
  options.armijo = 0.2;
  options.backtracking_factor = 0.8;
  options.domain_fraction = 0.5;
  options.max_expansion = 1;
  options.max_backtracks = 180;  // as far as 60 halvings
  return options;
}

newton::Summary run(const DistortionProblem& problem, Vector& x, const MethodOptions& options,
                    const newton::IterationCallback& callback) {
  BlendedQuasiNewton method(problem);
  return minimize_first_order(method, problem, x, options, callback);
}

}  // namespace

BlendedQuasiNewton::BlendedQuasiNewton(const DistortionProblem& problem) : QuasiNewton(search_options()) {
  const std::vector<double>& weights = problem.elements.weights;
  const double volume = std::accumulate(weights.begin(), weights.end(), 0.0), dim = problem.elements.dim;
  unit_ = std::pow(volume, (3 * dim - 4) / dim);
  if (problem.energy.has_barrier()) filter_.emplace(problem);
}

Vector BlendedQuasiNewton::secant(const Vector& s, Vector y, SharedPieces& pieces) {
  const ScopedTimer timer(pieces.seconds().solve);
  if (norm_ == 0) norm_ = pieces.metric().norm();
  Vector Hs;
  pieces.metric().product(s, Hs);
  const double beta = blend(norm_ / unit_, y, Hs);
  return (1 - beta) * y + beta * Hs;
}

void BlendedQuasiNewton::correct(const Vector& x, Vector& direction, SharedPieces& pieces) {
  if (!filter_) return;
  const ScopedTimer timer(pieces.seconds().line_search);
  filter_->apply(x, direction);
}

double blend(double relative_norm, const Vector& y, const Vector& Hs) {
  return std::clamp(relative_norm * y.dot(Hs), 0.0, 1.0);
}

std::vector<Method> bcqn_methods() {
  return {{{"bcqn", "blended cured quasi-Newton", "Zhu, Bridson, Kaufman 2018", Family::constant_metric},
           nullptr,
           run}};
}

}  // namespace isostretch::baselines
