#include "deformation.hpp"

#include <isostretch/assembly/deformation_operator.hpp>
#include <isostretch/sdp_penalty/isotropic_stretch.hpp>

#include <cstddef>

namespace isostretch::baselines {

std::vector<double> deformation_gradients(const assembly::Elements& elements, const Vector& x) {
  const auto count = static_cast<std::size_t>(elements.element_count());
  std::vector<double> F(count * static_cast<std::size_t>(elements.dim * elements.dim));
  assembly::deformation_gradients(elements, x.data(), 0, count, F.data(), count);
  return F;
}

std::vector<double> constraint_matrices(const sdp_penalty::Problem& problem, const std::vector<double>& F) {
  const auto count = static_cast<std::size_t>(problem.element_count());
  std::vector<double> S(F.size());
  sdp_penalty::isotropic_stretches(problem.dim(), count, problem.rotations.data(), F.data(), S.data(), count);
  return S;
}

}  // namespace isostretch::baselines
