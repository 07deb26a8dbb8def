#pragma once

#include <isostretch/core/vector.hpp>
#include <isostretch/newton/objective.hpp>
#include <isostretch/newton/options.hpp>

namespace isostretch::newton {

/// The result of a line search.
struct LineSearchResult {
  /// Whether a step gained enough.
  bool accepted = false;
  /// Accepted although, or refused because, the promised gain is below the rounding of the energy.
  bool at_roundoff = false;
  /// The length of the step, as a share of the direction.
  double step = 0;
  /// The change of the energy by the step.
  double change = 0;
  /// Gain of the first step tried over what the quadratic model promised for it; -infinity outside the
  /// domain.
  double model_fit = 0;
  /// The number of evaluations of the energy.
  int evaluations = 0;
};

/// Finds a step along the descent direction d (slope = gradient . d < 0) from x with that energy; `trial` is
/// x + step d when accepted.
///
/// Changes of the energy below `noise` mean nothing. Only energies are evaluated, and changes where terms
/// know them (Term::has_exact_change). Of the options those of the line search count. For minimisers of one's
/// own: minimize() calls it itself.
LineSearchResult search_line(Objective& objective, const Vector& x, const Vector& d, double energy,
                             double slope, double noise, const Options& options, Vector& trial);

}  // namespace isostretch::newton
