#include "shear_modulus.hpp"

#include <isostretch/core/error.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::baselines {
namespace {

template <int Dim>
double shear(const energies::AnyEnergy& energy) {
  invariants::PrincipalStretches<Dim, double> rest;
  std::fill_n(rest.sigma, Dim, 1.0);
  try {
    const double modulus = 0.5 * energies::derivatives_at(energy, rest).flip[0];
    return modulus > 0 && std::isfinite(modulus) ? modulus : 1;
  } catch (const Error&) {  // no energy to be at rest with
    return 1;
  }
}

}  // namespace

double shear_at_rest(const DistortionProblem& problem) {
  return problem.elements.dim == 2 ? shear<2>(problem.energy) : shear<3>(problem.energy);
}

}  // namespace isostretch::baselines
