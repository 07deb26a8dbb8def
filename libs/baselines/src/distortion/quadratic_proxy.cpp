// Accelerated quadratic proxy (Kovalsky, Galun, Lipman 2016): one step of a fixed quadratic model from a
// point ahead of the iterate,
//
//   y = x + a (x - x_before),  x_next = y - t H^-1 gradient(y),
//
// a = theta = (1 - sqrt(1/kappa)) / (1 + sqrt(1/kappa)), or half of the largest step in the domain if that is
// less; t by backtracking (share 0.2 of the slope, factor 0.5) from 2^5.5 times the last t, limited to 1 and
// to half of the largest step in the domain. The authors' examples have kappa = 100 for ARAP and 1000 for the
// barrier energy, which are the values here for energies without and with a barrier. For ARAP the proxy is
// the majorizer with rotations held: a full step, and no line search. Without acceleration that is
// local-global (their appendix B).
//
// Deviations: energies without a barrier other than ARAP, which those examples have none of, get the line
// search. A step that fails is tried once more without acceleration. And a share of 0.2 admits steps for
// which a fixed theta does not converge (1.6 over the curvature, where 2 (1 + theta) / (1 + 2 theta), about
// 4/3, is the most): on meshes that need little acceleration the published method goes round in circles some
// digits above the optimum. After 50 iterations without a new lowest energy acceleration starts afresh, and
// with 1/2 for the share from then on, which is Nesterov's own condition.
#include "first_order_driver.hpp"
#include "method_registry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isostretch::baselines {
namespace {

constexpr double domain_share = 0.5;
const double step_memory = std::pow(2.0, 5.5);

newton::Options search_options(double share_of_slope) {
  newton::Options options;
  options.armijo = share_of_slope;
  options.backtracking_factor = 0.5;
  options.domain_fraction = domain_share;
  options.max_expansion = 1;
  return options;
}

class QuadraticProxy final : public FirstOrderMethod {
 public:
  // theta 0: no acceleration.
  QuadraticProxy(const DistortionProblem& problem, double theta)
      : theta_(theta), majorizes_(problem.energy.name() == "arap") {}

  Step step(const Iterate& at, SharedPieces& pieces) override {
    if (theta_ > 0 && goes_round(at.energy)) {
      restart();
      share_of_slope_ = 0.5;
    }
    if (theta_ == 0 || before_.size() == 0) return descend(at, at, pieces);
    const Iterate ahead = extrapolate(at, pieces);
    return descend(at, ahead, pieces);
  }

  bool restart() override {
    const bool accelerated = theta_ > 0 && before_.size() > 0;
    before_.resize(0);
    last_step_ = 1;
    return accelerated;
  }

 private:
  // Whether the lowest energy has been the lowest for long; counts from there again.
  bool goes_round(double energy) {
    constexpr int patience = 50;
    since_lowest_ = energy < lowest_ ? 0 : since_lowest_ + 1;
    lowest_ = std::min(lowest_, energy);
    if (since_lowest_ < patience) return false;
    since_lowest_ = 0;
    return true;
  }

  Iterate extrapolate(const Iterate& at, SharedPieces& pieces) {
    const Vector ahead = at.x - before_;
    const double share =
        std::min(theta_, domain_share * pieces.objective().max_step(at.x, ahead, theta_ / domain_share));
    Iterate y;
    y.x = at.x + share * ahead;
    y.energy = pieces.differentiate(y.x, y.gradient).value;
    return y;
  }

  Step descend(const Iterate& at, const Iterate& from, SharedPieces& pieces) {
    Vector direction;
    pieces.solve(from.gradient, direction);
    direction = -direction;
    Step step = majorizes_ ? full_step(from, direction) : shortened_step(from, direction, pieces);
    if (step.taken) before_ = at.x;
    return step;
  }

  static Step full_step(const Iterate& from, const Vector& direction) {
    Step step;
    step.taken = true;
    step.x = from.x + direction;
    step.row.step = 1;
    step.row.decrement = -0.5 * from.gradient.dot(direction);
    return step;
  }

  Step shortened_step(const Iterate& from, Vector direction, SharedPieces& pieces) {
    const double longest = std::min(1.0, last_step_ * step_memory);
    direction *= longest;
    Step step = search_step(from, direction, search_options(share_of_slope_), pieces);
    step.row.decrement /= longest;
    step.row.step *= longest;
    if (step.taken) last_step_ = step.row.step;
    return step;
  }

  double theta_;
  bool majorizes_;
  Vector before_;  // the iterate before this one, or empty
  double last_step_ = 1;
  double share_of_slope_ = 0.2;
  double lowest_ = std::numeric_limits<double>::infinity();  // energy
  int since_lowest_ = 0;
};

double acceleration(const DistortionProblem& problem) {
  const double kappa = problem.energy.has_barrier() ? 1000 : 100;
  const double root = std::sqrt(1 / kappa);
  return (1 - root) / (1 + root);
}

newton::Summary run_aqp(const DistortionProblem& problem, Vector& x, const MethodOptions& options,
                        const newton::IterationCallback& callback) {
  QuadraticProxy method(problem, acceleration(problem));
  return minimize_first_order(method, problem, x, options, callback);
}

newton::Summary run_plain(const DistortionProblem& problem, Vector& x, const MethodOptions& options,
                          const newton::IterationCallback& callback) {
  QuadraticProxy method(problem, 0);
  return minimize_first_order(method, problem, x, options, callback);
}

}  // namespace

std::vector<Method> quadratic_proxy_methods() {
  return {
      {{"aqp", "accelerated quadratic proxy", "Kovalsky, Galun, Lipman 2016", Family::constant_metric},
       nullptr,
       run_aqp},
      {{"quadratic_proxy", "quadratic proxy", "Kovalsky, Galun, Lipman 2016, not accelerated",
        Family::constant_metric},
       nullptr,
       run_plain},
  };
}

}  // namespace isostretch::baselines
