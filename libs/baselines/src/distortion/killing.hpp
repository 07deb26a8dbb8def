#pragma once

#include "modelled_energy_term.hpp"

namespace isostretch::baselines {

// Claici, Bessmeltsev, Schaefer, Solomon 2017, "Isometry-aware preconditioning for mesh parameterization":
// the metric is the Killing energy of a vector field u on the body as it is deformed, integral of |grad u +
// grad u^T|^2 over it, which isometries make vanish. Scaled so that at rest it is what the energy has for
// shear.
class KillingTerm final : public ModelledEnergyTerm {
 public:
  explicit KillingTerm(const DistortionProblem& problem);

 private:
  void model(const Vector& x) override;
  template <int Dim>
  void model_elements(const Vector& x);

  double shear_;  // modulus of the energy at rest
};

}  // namespace isostretch::baselines
