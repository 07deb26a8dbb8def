#include "modelled_energy_term.hpp"

#include <cmath>

namespace isostretch::baselines {

ModelledEnergyTerm::ModelledEnergyTerm(const DistortionProblem& problem)
    : problem_(problem), assembler_(problem.elements, problem.energy) {}

newton::Evaluation ModelledEnergyTerm::differentiate(const Vector& x, const projection::FilterOptions&,
                                                     Vector& gradient, bool hessian) {
  constexpr projection::FilterOptions exact{projection::Filter::none, 0.0, 0.0, nullptr};
  const newton::Evaluation result =
      assembler_.differentiate(x.data(), exact, gradient.data(), hessian && wants_exact());
  if (!hessian || !std::isfinite(result.value)) return result;
  hessians_ = assembler_.element_hessians();
  model(x);
  return result;
}

}  // namespace isostretch::baselines
