#include <isostretch/newton/line_search.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::newton {
namespace {

// The model at hand was too stiff where the first step gains clearly more than it promised: barrier energies
// far from rest, and filtered Hessians. Energies are cheap beside a factorization, so go on while that pays.
void expand(Objective& objective, const Vector& x, const Vector& d, double energy, double slope,
            const Options& options, Vector& trial, LineSearchResult& best) {
  const double promised = -slope * best.step * (1 - 0.5 * best.step);
  if (energy - best.energy < options.expansion_ratio * promised) return;
  const double limit =
      options.domain_fraction * objective.max_step(x, d, options.max_expansion / options.domain_fraction);
  Vector further;
  while (best.step < limit) {
    const double step = std::min(options.expansion_factor * best.step, limit);
    further = x + step * d;
    const double value = objective.value(further).value;
    ++best.evaluations;
    if (!(value < best.energy)) return;
    best.step = step;
    best.energy = value;
    trial.swap(further);
  }
}

}  // namespace

LineSearchResult search_line(Objective& objective, const Vector& x, const Vector& d, double energy,
                             double slope, double noise, const Options& options, Vector& trial) {
  LineSearchResult result;
  const double limit = 1.0 / options.domain_fraction;
  double step = std::min(1.0, options.domain_fraction * objective.max_step(x, d, limit));
  // Where even the longest step promises next to nothing, equality is all that can be asked of a shorter one.
  constexpr double next_to_nothing = 1000;
  const bool near_end = -step * slope < next_to_nothing * noise;
  for (int i = 0; i < options.max_backtracks; ++i, step *= options.backtracking_factor) {
    trial = x + step * d;
    const double value = objective.value(trial).value;
    ++result.evaluations;
    if (i == 0) result.model_fit = (energy - value) / (-slope * step * (1 - 0.5 * step));
    const bool anything = options.line_search == LineSearch::none;
    const bool gained = value <= energy + options.armijo * step * slope;
    const bool drowned = -step * slope < 4 * noise;
    result.at_roundoff = near_end && drowned;
    if (drowned && !near_end && !anything) return result;
    if (std::isfinite(value) && (anything || gained || (result.at_roundoff && value <= energy + noise))) {
      result.accepted = true;
      result.step = step;
      result.energy = value;
      if (i == 0 && !anything && !result.at_roundoff)
        expand(objective, x, d, energy, slope, options, trial, result);
      return result;
    }
    if (result.at_roundoff) return result;
  }
  return result;
}

}  // namespace isostretch::newton
