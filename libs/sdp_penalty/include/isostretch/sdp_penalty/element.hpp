#pragma once

#include <isostretch/assembly/deformation_operator.hpp>
#include <isostretch/core/vector.hpp>
#include <isostretch/sdp_penalty/problem.hpp>

#include <cstddef>

// One linear element of a problem, in D dimensions: what the convex problem and its rivals are made of.

namespace isostretch::sdp_penalty {
inline namespace ISOSTRETCH_ISA {

/// Returns the map from positions to the deformation gradients of a problem's elements, of one point each.
template <int D>
assembly::DeformationOperator<D, D + 1> deformation(const Problem& problem) {
  return assembly::DeformationOperator<D, D + 1>(problem.elements);
}

/// Returns the rest gradients of element e, D entries a corner.
template <int D>
const double* rest_gradients(const Problem& problem, std::size_t e) {
  return deformation<D>(problem).rest_gradients(e);
}

/// Returns the ex-rotation R of element e.
template <int D>
linalg::Mat<D> rotation(const Problem& problem, std::size_t e) {
  return linalg::from_columns<D>(problem.rotations.data() + e * D * D);
}

/// Returns R^T F of element e at positions x, not made symmetric.
template <int D>
linalg::Mat<D> unrotated(const Problem& problem, std::size_t e, const Vector& x) {
  return transposed(rotation<D>(problem, e)) * deformation<D>(problem).apply(e, x.data());
}

/// Adds the second derivative of the elastic term of element e, w |F - R|^2 + kappa/2 (tr(R^T F) - D)^2, by
/// the positions of its corners a (rows) and b (columns). It is the same at all positions.
template <int D>
void add_elastic_block(const Problem& problem, std::size_t e, int a, int b, linalg::Mat<D>& sum) {
  const double *ga = rest_gradients<D>(problem, e) + a * D, *gb = rest_gradients<D>(problem, e) + b * D;
  double dot = 0;
  for (int c = 0; c < D; ++c) dot += ga[c] * gb[c];
  for (int r = 0; r < D; ++r) sum[r][r] += 2 * problem.weights[e] * dot;
  if (problem.incompressibility == 0) return;
  const linalg::Mat<D> R = rotation<D>(problem, e);
  double Ra[D] = {}, Rb[D] = {};  // gradients of tr(R^T F)
  for (int r = 0; r < D; ++r)
    for (int c = 0; c < D; ++c) {
      Ra[r] += R[r][c] * ga[c];
      Rb[r] += R[r][c] * gb[c];
    }
  for (int r = 0; r < D; ++r)
    for (int c = 0; c < D; ++c) sum[r][c] += problem.incompressibility * Ra[r] * Rb[c];
}

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch::sdp_penalty
