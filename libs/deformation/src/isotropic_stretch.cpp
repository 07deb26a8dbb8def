#include <isostretch/assembly/deformation_operator.hpp>
#include <isostretch/deformation/isotropic_stretch.hpp>
#include <isostretch/linalg/decompositions.hpp>
#include <isostretch/sdp_penalty/isotropic_stretch.hpp>

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
    sdp_penalty::isotropic_stretches(body.dim, here, rotations.data() + start * dim * dim, F.data(), S.data(),
                                     chunk);
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
