#include <isostretch/assembly/deformation_operator.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/core/timer.hpp>
#include <isostretch/linalg/decompositions.hpp>
#include <isostretch/sdp_penalty/relinearize.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace isostretch::sdp_penalty {
namespace {

template <int D>
std::vector<double> rotations_of(const assembly::Elements& elements, const Vector& x) {
  constexpr std::size_t entries = D * D;
  const auto count = static_cast<std::size_t>(elements.element_count());
  std::vector<double> F(count * entries), R(count * entries), S(count * entries), rotations(count * entries);
  assembly::deformation_gradients(elements, x.data(), 0, count, F.data(), count);
  linalg::polar(D, {F.data(), R.data(), S.data(), count, count});
  for (std::size_t e = 0; e < count; ++e)
    for (std::size_t r = 0; r < D; ++r)
      for (std::size_t c = 0; c < D; ++c) rotations[e * entries + r + D * c] = R[(r + D * c) * count + e];
  return rotations;
}

}  // namespace

std::vector<double> nearest_rotations(const assembly::Elements& elements, const Vector& x) {
  return elements.dim == 2 ? rotations_of<2>(elements, x) : rotations_of<3>(elements, x);
}

void RelinearizeOptions::validate() const {
  solve.validate();
  const auto require = [](bool condition, const char* text) {
    if (!condition) throw Error(std::string("re-linearised iteration: ") + text);
  };
  require(max_rounds > 0, "max_rounds must be positive");
  require(tolerance >= 0 && std::isfinite(tolerance), "tolerance must not be negative");
  require(soft_penalty > 0 && std::isfinite(soft_penalty), "soft_penalty must be positive");
}

Summary penalty_solution(const Problem& problem, Vector& x, double soft_penalty, const Options& options) {
  Options soft = options;
  soft.method = Method::penalty;
  soft.penalty = PenaltyOptions();
  soft.penalty.epsilon = 0;
  soft.penalty.first = std::min(1.0, soft_penalty);
  soft.penalty.last = soft_penalty;
  if (!problem.bounds_stretch()) return solve(problem, x, soft);
  Problem without_bound = problem;
  without_bound.largest_stretch = std::numeric_limits<double>::infinity();
  return solve(without_bound, x, soft);
}

RelinearizeSummary solve_relinearized(const Problem& problem, Vector& x, const RelinearizeOptions& options,
                                      const RoundCallback& callback) {
  options.validate();
  RelinearizeSummary result;
  Problem round_problem = problem;
  Solver solver(options.solve);
  double before = std::numeric_limits<double>::infinity();
  while (static_cast<int>(result.rounds.size()) < options.max_rounds && !result.settled && !result.stopped) {
    const Timer timer;
    RelinearizeRound round;
    result.last = solver.solve(round_problem, x);
    round.linear_solves = result.last.linear_solves;
    round.status = result.last.status;
    if (!result.last.feasible()) {
      Summary soft = penalty_solution(round_problem, x, options.soft_penalty, options.solve);
      round.penalty_solution = true;
      round.linear_solves += soft.linear_solves;
      // The numbers are those of x; what the convex problem's solve has proved stays.
      soft.status = result.last.status;
      soft.message = result.last.message;
      soft.infeasible_elements = std::move(result.last.infeasible_elements);
      soft.lower_bound = result.last.lower_bound;
      soft.unreachable_eigenvalue = result.last.unreachable_eigenvalue;
      soft.extent = result.last.extent;
      soft.iterations += result.last.iterations;
      soft.linear_solves = round.linear_solves;
      result.last = std::move(soft);
    }
    round.min_eigenvalue = result.last.min_eigenvalue;
    round.inverted = result.last.inverted;
    round.iterations = result.last.iterations;
    result.rotations = std::exchange(round_problem.rotations, nearest_rotations(problem.elements, x));
    round.energy = energy(round_problem, x);
    round.seconds = timer.seconds();
    result.rounds.push_back(round);
    result.settled =
        !round.penalty_solution && before - round.energy <= options.tolerance * std::abs(round.energy);
    before = round.penalty_solution ? std::numeric_limits<double>::infinity() : round.energy;
    result.stopped = callback && callback(round, x) == CallbackAction::stop;
  }
  return result;
}

}  // namespace isostretch::sdp_penalty
