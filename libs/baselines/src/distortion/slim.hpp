#pragma once

#include "modelled_energy_term.hpp"

namespace isostretch::baselines {

// Rabinovich, Poranne, Panozzo, Sorkine-Hornung 2017, "Scalable locally injective mappings": every step
// minimises sum w |W (F - R)|^2 with W = U diag(omega) U^T, whose gradient is the energy's where
//   omega_i^2 = (d psi / d sigma_i) / (2 (sigma_i - t_i)),
// t the nearest stretches that cost nothing: 1, or for scale-invariant energies what their paper calls the
// closest similarity. The published code adds a proximal term of 1e-4, which is left out. Its Hessian, 2 w
// W^2 between rest gradients, is this term's.
class SlimTerm final : public ModelledEnergyTerm {
 public:
  using ModelledEnergyTerm::ModelledEnergyTerm;

 private:
  void model(const Vector& x) override;
  template <int Dim>
  void model_elements(const Vector& x);
};

}  // namespace isostretch::baselines
