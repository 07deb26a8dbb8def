#pragma once

#include "determinant_filter.hpp"
#include "quasi_newton.hpp"

#include <optional>

namespace isostretch::baselines {

// Blended cured quasi-Newton (Zhu, Bridson, Kaufman 2018): L-BFGS about the metric H with
//
//   z = (1 - beta) y + beta H s,  beta = |H|_2 (y . H s) / V^((3 dim - 4) / dim) limited to [0, 1]
//
// in the place of y, V the rest area or volume: long steps, whose y says little about the Hessian, count as
// those of the plain proxy, short ones as L-BFGS has them. Directions pass the filter of determinants, for
// energies with a barrier; a direction that would not descend any more stays as it was. Backtracking (share
// 0.2 of the slope, factor 0.8) from the full step, or half of the largest in the domain, as in the authors'
// program.
//
// Deviations: in 3D the authors' program divides by V^(4/3), which makes beta depend on the unit of length;
// here it does not, and is the same where V = 1. It ends like all other methods, and not by the paper's
// characteristic gradient. Pairs with z . s <= 0 are left out, where the authors' program takes a small
// curvature instead. ARAP gets a line search too.
class BlendedQuasiNewton final : public QuasiNewton {
 public:
  explicit BlendedQuasiNewton(const DistortionProblem& problem);

 private:
  Vector secant(const Vector& s, Vector y, SharedPieces& pieces) override;
  void correct(const Vector& x, Vector& direction, SharedPieces& pieces) override;

  double unit_;      // V^((3 dim - 4) / dim)
  double norm_ = 0;  // |H|_2, 0: not yet known
  std::optional<DeterminantFilter> filter_;
};

// The beta above from |H|_2 / V^..., y and H s.
double blend(double relative_norm, const Vector& y, const Vector& Hs);

}  // namespace isostretch::baselines
