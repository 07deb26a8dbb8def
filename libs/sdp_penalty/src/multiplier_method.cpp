#include "multiplier_method.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace isostretch::sdp_penalty {
namespace {

constexpr double factor = 0.1, least = 1e-9, first_epsilon = 1e-7;
constexpr int most_rounds = 1000;  // where rounds no longer move anything

// Multipliers have the size of the weights, and start there.
Blocks first_multipliers(const Problem& problem) {
  const double weight = std::accumulate(problem.weights.begin(), problem.weights.end(), 0.0) /
                        static_cast<double>(problem.weights.size());
  const auto entries = static_cast<std::size_t>(problem.dim() * problem.dim()),
             diagonal = static_cast<std::size_t>(problem.dim() + 1);
  Blocks U(problem.weights.size() * entries, 0.0);
  for (std::size_t k = 0; k < U.size(); ++k)
    if (k % entries % diagonal == 0) U[k] = weight;
  return U;
}

}  // namespace

void multiplier_method(Workspace& work, const Options& options, Progress& progress, Vector& x,
                       MultiplierPenalty& penalty) {
  const Problem& problem = work.system.problem();
  double epsilon = first_epsilon, tolerance = 1e-8;
  double violation = std::numeric_limits<double>::infinity();
  penalty.bound = problem.margin + epsilon;
  penalty.set_multipliers(problem.dim(), first_multipliers(problem));
  const auto in_domain = [&](double wanted) {
    return std::max(wanted, penalty.least_parameter(progress.last().min_eigenvalue));
  };
  penalty.parameter = in_domain(penalty.parameter);
  Path path(work, options, progress, x);
  for (int round = 0; round < most_rounds && !progress.ended(); ++round) {
    path.minimise(penalty, tolerance);
    if (progress.ended()) break;
    tolerance = std::max(0.1 * tolerance, 1e-14);  // multipliers are as good as the minimiser is
    penalty.set_multipliers(problem.dim(), path.multiplier());
    const double left = std::max(0.0, penalty.bound - progress.last().min_eigenvalue);
    if (left > 0.25 * violation || left == 0)
      penalty.parameter = in_domain(std::max(factor * penalty.parameter, least));
    violation = left;
    // Feasible: only epsilon keeps the gap open.
    if (left <= 0.1 * epsilon) {
      epsilon *= 0.25 * std::min(1.0, options.gap_tolerance / progress.gap());
      penalty.bound = problem.margin + epsilon;
    }
  }
  if (!progress.ended())
    progress.give_up(Status::path_end, "the multipliers did not settle", x, {path.multiplier(), {}});
}

}  // namespace isostretch::sdp_penalty
