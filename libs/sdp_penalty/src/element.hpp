#pragma once

#include "small_matrix.hpp"

#include <isostretch/core/vector.hpp>
#include <isostretch/sdp_penalty/problem.hpp>

#include <cstddef>

namespace isostretch::sdp_penalty {

template <int D>
Small<D> rotation(const Problem& problem, std::size_t e) {
  return transposed(load<D>(problem.rotations.data() + e * D * D));  // they stand column by column
}

template <int D>
const double* gradients(const Problem& problem, std::size_t e) {
  return problem.elements.gradients.data() + e * (D + 1) * D;
}

template <int D>
Small<D> deformation_gradient(const assembly::Elements& elements, std::size_t e, const Vector& x) {
  const int* node = elements.nodes.data() + e * (D + 1);
  const double* g = elements.gradients.data() + e * (D + 1) * D;
  Small<D> F;
  for (int a = 0; a <= D; ++a)
    for (int r = 0; r < D; ++r)
      for (int c = 0; c < D; ++c) F(r, c) += x[node[a] * D + r] * g[a * D + c];
  return F;
}

// R^T F, not made symmetric.
template <int D>
Small<D> unrotated(const Problem& problem, std::size_t e, const Vector& x) {
  return transposed(rotation<D>(problem, e)) * deformation_gradient<D>(problem.elements, e, x);
}

}  // namespace isostretch::sdp_penalty
