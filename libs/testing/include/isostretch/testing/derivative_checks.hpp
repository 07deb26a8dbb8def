#pragma once

// Finite differences against a gradient and a Hessian given as functions, with a convergence sweep: central
// differences at steps from 1e-2 down to 1e-9 (relative to |x|). Passing needs both a small best error and,
// where truncation shows, an error that falls like the square of the step: a formula that is wrong in a small
// term has the first without the second, or neither.
//
//   const auto report = check_derivatives(psi, gradient, hessian_times, x);
//   CHECK_MESSAGE(report.ok(), report.text());
//
// psi(x) -> double, gradient(x) -> VectorXd, hessian_times(x, d) -> VectorXd; x is one vec'ed F, or all
// positions of a mesh. Errors are relative to what the next lower derivative and the next higher one make
// natural: |g| + |psi| / |x| + |H d| |x|, and |H d| + |g| / |x|.

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace isostretch::testing {

/// The choices of check_derivatives().
struct DifferenceOptions {
  int directions = 3;           ///< Random directions.
  double largest_step = 1e-2;   ///< First step of the sweep, relative to |x|.
  double smallest_step = 1e-9;  ///< Last step of the sweep, relative to |x|.
  double tolerance = 1e-7;      ///< Largest relative error that passes.
  double minimum_slope = 1.7;   ///< Least slope of the error where truncation shows; 2 in exact arithmetic.
  unsigned seed = 1;            ///< Seed of the directions.
};

/// The findings of one sweep over the steps.
struct Sweep {
  double best_error = std::numeric_limits<double>::infinity();  ///< Smallest relative error.
  double best_step = 0;  ///< Step of the smallest error, relative to |x|.
  /// d log(error) / d log(step) over the steps that truncation dominates; NaN where none does (the difference
  /// is exact to rounding, as for a quadratic).
  double slope = std::numeric_limits<double>::quiet_NaN();

  /// Returns whether the error is small and falls like the square of the step where truncation shows.
  bool ok(const DifferenceOptions& options) const {
    return best_error <= options.tolerance && !(slope < options.minimum_slope);
  }
};

/// The findings of check_derivatives().
struct DerivativeReport {
  /// The worst sweep of the gradient over all directions.
  Sweep gradient,
      hessian;  ///< The worst sweep of the Hessian over all directions.    ///< the worst over all directions
  Eigen::VectorXd x;          ///< The point of the check.
  DifferenceOptions options;  ///< The choices of the check.

  /// Returns whether gradient and Hessian pass.
  bool ok() const { return gradient.ok(options) && hessian.ok(options); }

  /// Returns the errors, steps and slopes as text.
  std::string text() const {
    std::ostringstream out;
    const auto line = [&](const char* what, const Sweep& s) {
      out << what << ": best relative error " << s.best_error << " at step " << s.best_step << ", slope "
          << s.slope << (s.ok(options) ? "\n" : "  FAILED\n");
    };
    line("gradient against differences of psi", gradient);
    line("Hessian against differences of the gradient", hessian);
    if (x.size() <= 12) out << "at x = " << x.transpose() << "\n";
    return out.str();
  }
};

namespace detail {

/// Returns the sweep of error(h) for h = largest, largest/10, ...; infinite or NaN errors (a step that leaves
/// the domain) are skipped.
template <class Error>
Sweep sweep_steps(Error error, const DifferenceOptions& options) {
  Sweep sweep;
  std::vector<double> steps, errors;
  for (double h = options.largest_step; h > 0.5 * options.smallest_step; h *= 0.1) {
    const double e = error(h);
    if (!std::isfinite(e)) continue;
    steps.push_back(h);
    errors.push_back(e);
    if (e < sweep.best_error) sweep.best_error = e, sweep.best_step = h;
  }
  // Truncation, not rounding: well above both the best error and what rounding does at that step.
  for (std::size_t i = 1; i < steps.size() && steps[i] >= sweep.best_step; ++i)
    if (errors[i] > std::max(100 * sweep.best_error, 1e-14 / steps[i]))
      sweep.slope = std::log(errors[0] / errors[i]) / std::log(steps[0] / steps[i]);
  return sweep;
}

inline void keep_worst(Sweep& worst, const Sweep& sweep, const DifferenceOptions& options) {
  const bool fresh = worst.best_step == 0 && !std::isfinite(worst.best_error);
  if (fresh || (worst.ok(options) && !sweep.ok(options)) || sweep.best_error > worst.best_error)
    worst = sweep;
}

inline Eigen::VectorXd random_direction(Eigen::Index size, std::mt19937& generator) {
  std::normal_distribution<double> normal;
  Eigen::VectorXd d(size);
  for (Eigen::Index i = 0; i < size; ++i) d[i] = normal(generator);
  return d.normalized();
}

}  // namespace detail

/// Compares a gradient and a Hessian with central differences at a sequence of steps: psi(x) returns a
/// double, gradient(x) a VectorXd and hessian_times(x, d) a VectorXd; x is one vec'ed F, or all positions of
/// a mesh. Passing needs both a small best error and, where truncation shows, an error that falls like the
/// square of the step: a formula that is wrong in a small term has the first without the second, or neither.
/// Errors are relative to |g| + |psi| / |x| + |H d| |x| and |H d| + |g| / |x|.
template <class Psi, class Gradient, class HessianTimes>
DerivativeReport check_derivatives(const Psi& psi, const Gradient& gradient,
                                   const HessianTimes& hessian_times, const Eigen::VectorXd& x,
                                   const DifferenceOptions& options = {}) {
  DerivativeReport report{{}, {}, x, options};
  std::mt19937 generator(options.seed);
  const double size = x.norm() > 0 ? x.norm() : 1.0;
  const Eigen::VectorXd g = gradient(x);
  for (int n = 0; n < options.directions; ++n) {
    const Eigen::VectorXd d = detail::random_direction(x.size(), generator), Hd = hessian_times(x, d);
    const double g_scale = g.norm() + std::abs(psi(x)) / size + Hd.norm() * size + 1e-300;
    const double H_scale = Hd.norm() + g.norm() / size + 1e-300;
    const auto g_error = [&](double step) {
      const double h = step * size;
      return std::abs((psi(x + h * d) - psi(x - h * d)) / (2 * h) - g.dot(d)) / g_scale;
    };
    const auto H_error = [&](double step) {
      const double h = step * size;
      const Eigen::VectorXd difference = (gradient(x + h * d) - gradient(x - h * d)) / (2 * h);
      return (difference - Hd).norm() / H_scale;
    };
    detail::keep_worst(report.gradient, detail::sweep_steps(g_error, options), options);
    detail::keep_worst(report.hessian, detail::sweep_steps(H_error, options), options);
  }
  return report;
}

}  // namespace isostretch::testing
