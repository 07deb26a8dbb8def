#pragma once

#include "scaling_matrix.hpp"

#include <algorithm>

namespace isostretch::baselines {

// Smith, de Goes, Kim 2018, "Stable Neo-Hookean flesh simulation": for psi = f(I2) + g(I3) the Hessian is 2
// P2 I + P3 dd(det F) + P22 (2 F)(2 F)^T + P33 cof cof^T. The eigenvectors of dd(det F) are known, and
// shared by I; the sum of the first two terms is clamped along them (the three scalings by a cubic, here by a
// direct decomposition of the 3 x 3 block), the last two are semi-definite and added as they are. Hence not
// the nearest semi-definite matrix, but one above it.
//
// 4 P2 = flip + twist, and 2 sigma_i P3 = twist - flip for the pair without i (sigma_i = 1 in 2D): nothing of
// the energy has to be known.
struct Smith2018Rule {
  template <int Dim>
  void operator()(const invariants::PrincipalStretches<Dim, double>&,
                  invariants::StretchDerivatives<Dim, double>& d) const {
    const ScalingMatrix<Dim> A = scaling_matrix<Dim>(d);
    ScalingMatrix<Dim> first_two;
    for (int i = 0; i < d.pairs; ++i) {
      const int j = invariants::first<Dim>(i), k = invariants::second<Dim>(i);
      first_two(j, j) = first_two(k, k) = 0.5 * (d.twist[i] + d.flip[i]);
      first_two(j, k) = first_two(k, j) = 0.5 * (d.twist[i] - d.flip[i]);
      d.twist[i] = std::max(0.0, d.twist[i]);
      d.flip[i] = std::max(0.0, d.flip[i]);
    }
    Eigen::SelfAdjointEigenSolver<ScalingMatrix<Dim>> eigen;
    eigen.computeDirect(first_two);
    set_scaling_matrix<Dim>(clamped(eigen) + (A - first_two), d);
  }
};

}  // namespace isostretch::baselines
