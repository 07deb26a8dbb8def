#pragma once

#include <isostretch/assembly/deformation_operator.hpp>
#include <isostretch/core/vector.hpp>
#include <isostretch/sdp_penalty/problem.hpp>

#include <cstddef>

namespace isostretch::sdp_penalty {

using linalg::Mat;

// F of linear elements, which have one quadrature point each.
template <int D>
assembly::DeformationOperator<D, D + 1> deformation(const Problem& problem) {
  return assembly::DeformationOperator<D, D + 1>(problem.elements);
}

template <int D>
Mat<D> rotation(const Problem& problem, std::size_t e) {
  return linalg::from_columns<D>(problem.rotations.data() + e * D * D);
}

template <int D>
const double* rest_gradients(const Problem& problem, std::size_t e) {
  return deformation<D>(problem).rest_gradients(e);
}

// R^T F, not made symmetric.
template <int D>
Mat<D> unrotated(const Problem& problem, std::size_t e, const Vector& x) {
  return transposed(rotation<D>(problem, e)) * deformation<D>(problem).apply(e, x.data());
}

}  // namespace isostretch::sdp_penalty
