#include "deformation.hpp"

#include <isostretch/assembly/deformation_operator.hpp>

#include <cstddef>

namespace isostretch::baselines {

std::vector<double> deformation_gradients(const assembly::Elements& elements, const Vector& x) {
  const auto count = static_cast<std::size_t>(elements.element_count());
  std::vector<double> F(count * static_cast<std::size_t>(elements.dim * elements.dim));
  assembly::deformation_gradients(elements, x.data(), 0, count, F.data(), count);
  return F;
}

std::vector<double> constraint_matrices(const sdp_penalty::Problem& problem, const std::vector<double>& F) {
  const auto count = static_cast<std::size_t>(problem.element_count()),
             dim = static_cast<std::size_t>(problem.dim());
  std::vector<double> S(F.size(), 0.0);
  for (std::size_t e = 0; e < count; ++e) {
    const double* R = problem.rotations.data() + e * dim * dim;
    for (std::size_t i = 0; i < dim; ++i)
      for (std::size_t j = 0; j < dim; ++j)
        for (std::size_t k = 0; k < dim; ++k)
          S[(i + dim * j) * count + e] += 0.5 * (R[k + dim * i] * F[(k + dim * j) * count + e] +
                                                 R[k + dim * j] * F[(k + dim * i) * count + e]);
  }
  return S;
}

}  // namespace isostretch::baselines
