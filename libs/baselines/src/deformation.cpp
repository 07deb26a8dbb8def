#include "deformation.hpp"

#include <cstddef>

namespace isostretch::baselines {

std::vector<double> deformation_gradients(const assembly::Elements& elements, const Vector& x) {
  const auto count = static_cast<std::size_t>(elements.element_count()),
             dim = static_cast<std::size_t>(elements.dim);
  std::vector<double> F(count * dim * dim, 0.0);
  for (std::size_t e = 0; e < count; ++e)
    for (std::size_t a = 0; a <= dim; ++a) {
      const double* g = elements.gradients.data() + (e * (dim + 1) + a) * dim;
      const double* p = x.data() + static_cast<std::ptrdiff_t>(dim) * elements.nodes[e * (dim + 1) + a];
      for (std::size_t r = 0; r < dim; ++r)
        for (std::size_t c = 0; c < dim; ++c) F[(r + dim * c) * count + e] += p[r] * g[c];
    }
  return F;
}

std::vector<double> determinants(const assembly::Elements& elements, const Vector& x) {
  const std::vector<double> F = deformation_gradients(elements, x);
  const auto count = static_cast<std::size_t>(elements.element_count());
  std::vector<double> result(count);
  const auto f = [&](std::size_t e, std::size_t r, std::size_t c) {
    return F[(r + static_cast<std::size_t>(elements.dim) * c) * count + e];
  };
  for (std::size_t e = 0; e < count; ++e)
    result[e] = elements.dim == 2 ? f(e, 0, 0) * f(e, 1, 1) - f(e, 0, 1) * f(e, 1, 0)
                                  : f(e, 0, 0) * (f(e, 1, 1) * f(e, 2, 2) - f(e, 1, 2) * f(e, 2, 1)) -
                                        f(e, 0, 1) * (f(e, 1, 0) * f(e, 2, 2) - f(e, 1, 2) * f(e, 2, 0)) +
                                        f(e, 0, 2) * (f(e, 1, 0) * f(e, 2, 1) - f(e, 1, 1) * f(e, 2, 0));
  return result;
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
