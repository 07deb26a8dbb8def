#pragma once

#include <isostretch/core/vector.hpp>
#include <isostretch/sdp_penalty/problem.hpp>

#include <limits>

namespace isostretch::baselines {

/// Measures of positions, whoever found them.
struct Measures {
  /// The energy of the convex problem.
  double energy = std::numeric_limits<double>::quiet_NaN();
  /// The part of the energy that soft targets have.
  double target_energy = std::numeric_limits<double>::quiet_NaN();
  /// sum w_i |F_i - Q_i|^2 with the nearest rotation Q_i of each element, whatever its ex-rotation.
  double distortion = std::numeric_limits<double>::quiet_NaN();
  /// The least eigenvalue of all S_i.
  double min_eigenvalue = std::numeric_limits<double>::quiet_NaN();
  /// The least determinant of all F_i.
  double min_determinant = std::numeric_limits<double>::quiet_NaN();
  /// Elements with an eigenvalue of S below the margin, or longer than largest_stretch; -1: not known.
  int infeasible = -1;
  int inverted = -1;  ///< elements with det F <= 0
};

/// Returns the measures of positions x. Positions that are not finite have measures that are not finite, and
/// every element infeasible and inverted.
Measures measure(const sdp_penalty::Problem& problem, const Vector& x);

}  // namespace isostretch::baselines
