#pragma once

#include "scaling_matrix.hpp"

#include <algorithm>
#include <cmath>

namespace isostretch::baselines {

// Stomakhin, Howes, Schroeder, Teran 2012, "Energetically consistent invertible elasticity": the blocks of
// Teran et al. from principal stresses, (psi_j + psi_k) / (sigma_j + sigma_k) with its denominator kept away
// from zero and (psi_j - psi_k) / (sigma_j - sigma_k) with the difference cancelled by hand, as the flip
// eigenvalue of the energy is; 2 x 2 blocks clamped in closed form, A by a direct decomposition.
struct StomakhinRule {
  static constexpr double least_denominator = 1e-6;

  template <int Dim>
  void operator()(const invariants::PrincipalStretches<Dim, double>& s,
                  invariants::StretchDerivatives<Dim, double>& d) const {
    Eigen::SelfAdjointEigenSolver<ScalingMatrix<Dim>> eigen;
    eigen.computeDirect(scaling_matrix<Dim>(d));
    set_scaling_matrix<Dim>(clamped(eigen), d);
    for (int i = 0; i < d.pairs; ++i) {
      const int j = invariants::first<Dim>(i), k = invariants::second<Dim>(i);
      const double sum = s.sigma[j] + s.sigma[k];
      const double denominator = std::copysign(std::max(std::abs(sum), least_denominator), sum);
      d.twist[i] = std::max(0.0, (d.gradient[j] + d.gradient[k]) / denominator);
      d.flip[i] = std::max(0.0, d.flip[i]);
    }
  }
};

}  // namespace isostretch::baselines
