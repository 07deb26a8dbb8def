#include <isostretch/core/backtracking.hpp>
#include <isostretch/newton/line_search.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::newton {
namespace {

// By how much the objective changes from x along d: the difference of its values, but for the terms that know
// their changes better than values can tell.
class Change {
 public:
  Change(Objective& objective, const Vector& x, const Vector& d, double energy)
      : objective_(objective),
        x_(x),
        d_(d),
        exact_(objective.has_exact_changes()),
        before_(exact_ ? objective.value_without_exact(x).value : energy) {}

  // Leaves the positions in `there`.
  double operator()(double step, Vector& there) const {
    there = x_ + step * d_;
    if (!exact_) return objective_.value(there).value - before_;
    return objective_.exact_change(x_, d_, step) + (objective_.value_without_exact(there).value - before_);
  }

 private:
  Objective& objective_;
  const Vector& x_;
  const Vector& d_;
  bool exact_;
  double before_;
};

// The model at hand was too stiff where the first step gains clearly more than it promised: barrier energies
// far from rest, and filtered Hessians. Energies are cheap beside a factorization, so go on while that pays.
void expand(const Change& change, double limit, const Options& options, Vector& trial,
            LineSearchResult& best) {
  Vector further;
  while (best.step < limit) {
    const double step = std::min(options.expansion_factor * best.step, limit);
    const double by = change(step, further);
    ++best.evaluations;
    if (!(by < best.change)) return;
    best.step = step;
    best.change = by;
    trial.swap(further);
  }
}

// What the quadratic model promises a step to gain.
double promised(double slope, double step) {
  return -slope * step * (1 - 0.5 * step);
}

}  // namespace

LineSearchResult search_line(Objective& objective, const Vector& x, const Vector& d, double energy,
                             double slope, double noise, const Options& options, Vector& trial) {
  LineSearchResult result;
  const Change change(objective, x, d, energy);
  const double limit = 1.0 / options.domain_fraction;
  const double first = std::min(1.0, options.domain_fraction * objective.max_step(x, d, limit));
  const bool anything = options.line_search == LineSearch::none;
  // Where even the longest step promises next to nothing, equality is all that can be asked of a shorter one.
  constexpr double next_to_nothing = 1000;
  const bool near_end = -first * slope < next_to_nothing * noise;
  const auto judge = [&](double step, double by) {
    const bool gained = by <= options.armijo * step * slope;
    const bool drowned = -step * slope < 4 * noise;
    if (step == first) result.model_fit = -by / promised(slope, step);
    result.at_roundoff = near_end && drowned;
    if (drowned && !near_end && !anything) return Trial::give_up;
    if (std::isfinite(by) && (anything || gained || (result.at_roundoff && by <= noise)))
      return Trial::accept;
    return result.at_roundoff ? Trial::give_up : Trial::shorten;
  };
  const BacktrackedStep found = backtrack(
      {first, options.backtracking_factor, options.max_backtracks},
      [&](double step) { return change(step, trial); }, judge);
  result.evaluations = found.evaluations;
  result.accepted = found.accepted;
  if (!found.accepted) return result;
  result.step = found.step;
  result.change = found.change;
  if (found.evaluations == 1 && !anything && !result.at_roundoff &&
      -result.change >= options.expansion_ratio * promised(slope, result.step)) {
    const double furthest =
        options.domain_fraction * objective.max_step(x, d, options.max_expansion / options.domain_fraction);
    expand(change, furthest, options, trial, result);
  }
  return result;
}

}  // namespace isostretch::newton
