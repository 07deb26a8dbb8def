
#include <isostretch/deformation/isotropic_stretch.hpp>
#include <isostretch/linalg/decompositions.hpp>

#include <algorithm>
#include <array>

namespace isostretch::deformation {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

Matrix deformation_gradient(const assembly::Elements& e, std::size_t element, const Vector& x) {
  const auto k = static_cast<std::size_t>(e.nodes_per_element), dim = static_cast<std::size_t>(e.dim);
  Matrix F{};
  for (std::size_t a = 0; a < k; ++a) {
    const double* g = e.gradients.data() + (element * k + a) * dim;
    const double* p = x.data() + static_cast<std::ptrdiff_t>(dim) * e.nodes[element * k + a];
    for (std::size_t i = 0; i < dim; ++i)
      for (std::size_t j = 0; j < dim; ++j) F[i][j] += p[i] * g[j];
  }
  return F;
}

}  // namespace

std::vector<double> least_eigenvalues(const SolidModel& body, const std::vector<double>& rotations,
                                      const Vector& positions) {
  constexpr std::size_t chunk = 1024;
  const auto count = static_cast<std::size_t>(body.elements.element_count()),
             dim = static_cast<std::size_t>(body.dim);
  std::vector<double> S(dim * dim * chunk), lambda(dim * chunk), result(count);
  for (std::size_t start = 0; start < count; start += chunk) {
    const std::size_t here = std::min(chunk, count - start);
    for (std::size_t n = 0; n < here; ++n) {
      const Matrix F = deformation_gradient(body.elements, start + n, positions);
      const double* R = rotations.data() + (start + n) * dim * dim;
      for (std::size_t i = 0; i < dim; ++i)
        for (std::size_t j = 0; j < dim; ++j) {
          double sum = 0;
          for (std::size_t k = 0; k < dim; ++k) sum += R[k + dim * i] * F[k][j] + R[k + dim * j] * F[k][i];
          S[(i + dim * j) * chunk + n] = 0.5 * sum;
        }
    }
    linalg::symmetric_eigen(body.dim, {S.data(), lambda.data(), nullptr, here, chunk});
    for (std::size_t n = 0; n < here; ++n) {
      result[start + n] = lambda[n];
      for (std::size_t i = 1; i < dim; ++i)
        result[start + n] = std::min(result[start + n], lambda[i * chunk + n]);
    }
  }
  return result;
}

}  // namespace isostretch::deformation
