#include <isostretch/assembly/deformation_operator.hpp>
#include <isostretch/deformation/isotropic_stretch.hpp>
#include <isostretch/linalg/decompositions.hpp>

#include <algorithm>

namespace isostretch::deformation {

std::vector<double> least_eigenvalues(const SolidModel& body, const std::vector<double>& rotations,
                                      const Vector& positions) {
  constexpr std::size_t chunk = 1024;
  const auto count = static_cast<std::size_t>(body.elements.element_count()),
             dim = static_cast<std::size_t>(body.dim);
  std::vector<double> F(dim * dim * chunk), S(F.size()), lambda(dim * chunk), result(count);
  for (std::size_t start = 0; start < count; start += chunk) {
    const std::size_t here = std::min(chunk, count - start);
    assembly::deformation_gradients(body.elements, positions.data(), start, here, F.data(), chunk);
    for (std::size_t n = 0; n < here; ++n) {
      const double* R = rotations.data() + (start + n) * dim * dim;
      for (std::size_t i = 0; i < dim; ++i)
        for (std::size_t j = 0; j < dim; ++j) {
          double sum = 0;
          for (std::size_t k = 0; k < dim; ++k)
            sum +=
                R[k + dim * i] * F[(k + dim * j) * chunk + n] + R[k + dim * j] * F[(k + dim * i) * chunk + n];
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
