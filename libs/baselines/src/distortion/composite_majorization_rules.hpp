#pragma once

#include "scaling_matrix.hpp"

#include <algorithm>

namespace isostretch::baselines {

// Shtengel, Poranne, Sorkine-Hornung, Kovalsky, Lipman 2017, "Geometric optimization via composite
// majorization", in 2D: psi = h(g(F)), h of the singular values; the Hessian of g gets the derivatives of h
// where that is convex, h its convex part. All three rules take for that the nearest semi-definite matrix to
// the Hessian of h, which is that Hessian itself for the separable energies of the paper.

// As the published code has it: through the cones |alpha| = (sigma_1 + sigma_2) / 2 and |beta| = (sigma_1 -
// sigma_2) / 2 of similarities and anti-similarities, both convex, with the derivatives of psi by them where
// these are positive.
struct ConesRule {
  template <int Dim>
  void operator()(const invariants::PrincipalStretches<Dim, double>& s,
                  invariants::StretchDerivatives<Dim, double>& d) const {
    if constexpr (Dim == 2) {
      constexpr double nothing = 1e-7;  // of the published code: below, the quotient is rounding
      const double by_alpha = d.gradient[0] + d.gradient[1], by_beta = d.gradient[0] - d.gradient[1];
      set_scaling_matrix<2>(nearest_semidefinite<2>(scaling_matrix<2>(d)), d);
      d.twist[0] = std::max(0.0, by_alpha) / s.safe_sum(0);
      // There the published code has nothing at all; the limit costs as little.
      d.flip[0] = by_beta > nothing ? by_beta / (s[0] - s[1]) : std::max(0.0, d.flip[0]);
    }
  }
};

// As the paper's theorem has it, for each singular value by itself: sigma_1 = |alpha| + |beta| is convex,
// sigma_2 = |alpha| - |beta| the difference of two that are. The second quotient is infinite at conformal F
// with sigma < 1, a stiffness that is bounded here.
struct SingularValuesRule {
  template <int Dim>
  void operator()(const invariants::PrincipalStretches<Dim, double>& s,
                  invariants::StretchDerivatives<Dim, double>& d) const {
    if constexpr (Dim == 2) {
      constexpr double least_difference = 1e-6;
      const double convex = std::max(0.0, d.gradient[0]) + std::max(0.0, d.gradient[1]),
                   concave = std::max(0.0, d.gradient[0]) - std::min(0.0, d.gradient[1]);
      set_scaling_matrix<2>(nearest_semidefinite<2>(scaling_matrix<2>(d)), d);
      d.twist[0] = convex / s.safe_sum(0);
      d.flip[0] = concave / std::max(s[0] - s[1], least_difference * s[0]);
    }
  }
};

// ARAP as 2 |alpha|^2 + 2 |beta|^2 + 2 with the concave -4 |alpha| linearised: the Hessian is 2 I, that of
// |F|^2, and its steps are those of local-global.
struct AlphaBetaRule {
  template <int Dim>
  void operator()(const invariants::PrincipalStretches<Dim, double>&,
                  invariants::StretchDerivatives<Dim, double>& d) const {
    for (int i = 0; i < Dim; ++i) d.diagonal[i] = 2;
    for (int i = 0; i < d.pairs; ++i) {
      d.coupling[i] = 0;
      d.twist[i] = d.flip[i] = 2;
    }
  }
};

}  // namespace isostretch::baselines
