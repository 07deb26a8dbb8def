#pragma once

#include "scaling_matrix.hpp"

#include <algorithm>
#include <cmath>

namespace isostretch::baselines {

// Chen, Weber 2017, "GPU-accelerated locally injective shape deformation": in 2D all four eigenvalues in
// closed form over the complex derivatives, a = |f_z| = (sigma_1 + sigma_2) / 2 and b = |f_zbar| = (sigma_1 -
// sigma_2) / 2. Two are the twist and the flip; the others are those of the Hessian E of psi(a, b),
//   lambda_3, lambda_4 = s_1 +- sqrt(s_2^2 + E_ab^2), s_1, s_2 = (E_aa +- E_bb) / 2,
// with eigenvectors (1, t), t = (lambda - E_aa) / E_ab.
//
// That quotient is 0 / 0 where E_ab vanishes, as it does at every conformal F, and loses digits nearby.
// chen_weber_scaling() is the formula as it is; the rule falls back to a decomposition where that is not
// finite.
inline Eigen::Matrix2d chen_weber_scaling(const Eigen::Matrix2d& A) {
  const double E_aa = A(0, 0) + 2 * A(0, 1) + A(1, 1), E_bb = A(0, 0) - 2 * A(0, 1) + A(1, 1),
               E_ab = A(0, 0) - A(1, 1);
  const double s1 = 0.5 * (E_aa + E_bb), s2 = 0.5 * (E_aa - E_bb), root = std::sqrt(s2 * s2 + E_ab * E_ab);
  const double lambda3 = s1 + root, lambda4 = s1 - root;
  if (lambda4 >= 0) return A;
  if (lambda3 <= 0) return Eigen::Matrix2d::Zero();
  // lambda_3 (1, t)(1, t)^T / (1 + t^2), from the frame of (a, b) to that of the singular values.
  const double t = (lambda3 - E_aa) / E_ab, scale = lambda3 / (1 + t * t);
  const Eigen::Vector2d v(0.5 * (1 + t), 0.5 * (1 - t));
  return scale * v * v.transpose();
}

struct ChenWeberRule {
  template <int Dim>
  void operator()(const invariants::PrincipalStretches<Dim, double>&,
                  invariants::StretchDerivatives<Dim, double>& d) const {
    if constexpr (Dim == 2) {
      const Eigen::Matrix2d A = scaling_matrix<2>(d), closed = chen_weber_scaling(A);
      set_scaling_matrix<2>(closed.allFinite() ? closed : nearest_semidefinite<2>(A), d);
      d.twist[0] = std::max(0.0, d.twist[0]);
      d.flip[0] = std::max(0.0, d.flip[0]);
    }
  }
};

}  // namespace isostretch::baselines
