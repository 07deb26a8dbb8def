#pragma once

#include "scaling_matrix.hpp"

namespace isostretch::baselines {

// Teran, Sifakis, Irving, Fedkiw 2005, "Robust quasistatic finite elements and flesh simulation": in the
// frame of the singular vectors the Hessian falls into A and a 2 x 2 block [p q; q p] a pair of axes, p =
// (flip + twist) / 2, q = (flip - twist) / 2. Each is diagonalised numerically and clamped.
struct TeranRule {
  template <int Dim>
  void operator()(const invariants::PrincipalStretches<Dim, double>&,
                  invariants::StretchDerivatives<Dim, double>& d) const {
    set_scaling_matrix<Dim>(nearest_semidefinite<Dim>(scaling_matrix<Dim>(d)), d);
    for (int i = 0; i < d.pairs; ++i) {
      Eigen::Matrix2d B;
      B(0, 0) = B(1, 1) = 0.5 * (d.flip[i] + d.twist[i]);
      B(0, 1) = B(1, 0) = 0.5 * (d.flip[i] - d.twist[i]);
      B = nearest_semidefinite<2>(B);
      d.twist[i] = B(0, 0) - B(0, 1);
      d.flip[i] = B(0, 0) + B(0, 1);
    }
  }
};

}  // namespace isostretch::baselines
