#pragma once

// Kernel template, for T = double or Pack: the one place where F is made of positions and rest gradients.

#include <isostretch/linalg/matrix.hpp>

namespace isostretch::assembly {
inline namespace ISOSTRETCH_ISA {

/// Returns F = sum over the nodes a of an element of x_a g_a^T, where position(a, r) gives entry r of x_a and
/// rest_gradient(a, c) entry c of g_a. Rest gradients add up to zero over an element, so that g_0 is minus
/// the sum of the others: differences to node 0 make F exact for translations, and one node cheaper.
template <int Dim, class T, class Position, class RestGradient>
ISOSTRETCH_INLINE linalg::Mat<Dim, T> deformation_gradient(int nodes, const Position& position,
                                                           const RestGradient& rest_gradient) {
  linalg::Mat<Dim, T> F;
  for (int a = 1; a < nodes; ++a) {
    T difference[Dim], g[Dim];
    for (int c = 0; c < Dim; ++c) {
      difference[c] = position(a, c) - position(0, c);
      g[c] = rest_gradient(a, c);
    }
    for (int r = 0; r < Dim; ++r)
      for (int c = 0; c < Dim; ++c)
        F[r][c] = a == 1 ? difference[r] * g[c] : fma(difference[r], g[c], F[r][c]);
  }
  return F;
}

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch::assembly
