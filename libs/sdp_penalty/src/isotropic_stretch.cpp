#include <isostretch/sdp_penalty/isotropic_stretch.hpp>

namespace isostretch::sdp_penalty {

void isotropic_stretches(int dim, std::size_t count, const double* rotations, const double* F, double* S,
                         std::size_t stride) {
  const auto d = static_cast<std::size_t>(dim);
  for (std::size_t e = 0; e < count; ++e) {
    const double* R = rotations + e * d * d;
    for (std::size_t i = 0; i < d; ++i)
      for (std::size_t j = 0; j < d; ++j) {
        double sum = 0;
        for (std::size_t k = 0; k < d; ++k)
          sum += R[k + d * i] * F[(k + d * j) * stride + e] + R[k + d * j] * F[(k + d * i) * stride + e];
        S[(i + d * j) * stride + e] = 0.5 * sum;
      }
  }
}

}  // namespace isostretch::sdp_penalty
