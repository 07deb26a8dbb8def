#pragma once

// Kernel templates: first Piola-Kirchhoff stress and Hessian blocks from the derivatives in the singular
// frame.
//
// For a displacement x_a of a node with rest gradient b_a, dF = x_a b_a^T = U X V^T with X_ij = (U^T x_a)_i
// (V^T b_a)_j, and the second derivative of psi along X is
//   sum_ij A_ij X_ii X_jj + sum_pairs p (X_jk^2 + X_kj^2) + 2 q X_jk X_kj,  p = (flip + twist)/2, q = (flip -
//   twist)/2.
// Hence the dim x dim block between nodes a and b is U M U^T with, for g = V^T b_a and h = V^T b_b,
//   M_ii = A_ii g_i h_i + sum_j p_ij g_j h_j,   M_ij = A_ij g_i h_j + q_ij g_j h_i:
// no dim^2 x dim^2 matrix is ever formed.

#include <isostretch/invariants/stretch.hpp>
#include <isostretch/linalg/matrix.hpp>

namespace isostretch::projection {
inline namespace ISOSTRETCH_ISA {

using linalg::Mat;

/// Returns the first Piola-Kirchhoff stress P = d psi / d F = U diag(d psi / d sigma) V^T.
template <int Dim, class T>
ISOSTRETCH_INLINE Mat<Dim, T> pk1(const Mat<Dim, T>& U, const T (&gradient)[Dim], const Mat<Dim, T>& V) {
  Mat<Dim, T> P;
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) {
      T sum = U[i][0] * gradient[0] * V[j][0];
      for (int k = 1; k < Dim; ++k) sum = fma(U[i][k] * gradient[k], V[j][k], sum);
      P[i][j] = sum;
    }
  return P;
}

/// The Hessian at a point in the singular frame, multiplied by a weight: A, p = (flip + twist) / 2 and q =
/// (flip - twist) / 2.
template <int Dim, class T>
struct BlockCoefficients {
  T A[Dim][Dim];
  T p[Dim][Dim];
  T q[Dim][Dim];

  ISOSTRETCH_INLINE BlockCoefficients(const invariants::StretchDerivatives<Dim, T>& d, T weight) {
    for (int i = 0; i < Dim; ++i) A[i][i] = weight * d.diagonal[i];
    const T half = T(0.5) * weight;
    for (int i = 0; i < d.pairs; ++i) {
      const int j = invariants::first<Dim>(i), k = invariants::second<Dim>(i);
      A[j][k] = A[k][j] = weight * d.coupling[i];
      p[j][k] = p[k][j] = half * (d.flip[i] + d.twist[i]);
      q[j][k] = q[k][j] = half * (d.flip[i] - d.twist[i]);
    }
  }

  /// Returns the dim x dim block U M U^T between two nodes, given their rest gradients g and h in the frame
  /// of V: M_ii = A_ii g_i h_i + sum_j p_ij g_j h_j, M_ij = A_ij g_i h_j + q_ij g_j h_i.
  ISOSTRETCH_INLINE Mat<Dim, T> block(const Mat<Dim, T>& U, const T (&g)[Dim], const T (&h)[Dim]) const {
    Mat<Dim, T> M;
    T gh[Dim];
    for (int i = 0; i < Dim; ++i) gh[i] = g[i] * h[i];
    for (int i = 0; i < Dim; ++i)
      for (int j = 0; j < Dim; ++j) {
        if (i == j) {
          T sum = A[i][i] * gh[i];
          for (int k = 0; k < Dim; ++k)
            if (k != i) sum = fma(p[i][k], gh[k], sum);
          M[i][i] = sum;
        } else {
          M[i][j] = fma(A[i][j] * g[i], h[j], q[i][j] * g[j] * h[i]);
        }
      }
    Mat<Dim, T> UM, result;
    for (int i = 0; i < Dim; ++i)
      for (int j = 0; j < Dim; ++j) {
        T sum = U[i][0] * M[0][j];
        for (int k = 1; k < Dim; ++k) sum = fma(U[i][k], M[k][j], sum);
        UM[i][j] = sum;
      }
    for (int i = 0; i < Dim; ++i)
      for (int j = 0; j < Dim; ++j) {
        T sum = UM[i][0] * U[j][0];
        for (int k = 1; k < Dim; ++k) sum = fma(UM[i][k], U[j][k], sum);
        result[i][j] = sum;
      }
    return result;
  }
};

/// Calls sink(a, b, K_ab) for every block a <= b of an element of Nodes nodes, given the rest gradients of
/// nodes 1, 2, ... in the frame of V. Rest gradients add up to zero over an element, hence so do rows of
/// blocks: those of node 0 are minus the sums of the others.
template <int Dim, int Nodes, class T, class Sink>
ISOSTRETCH_INLINE void for_each_block(const BlockCoefficients<Dim, T>& coefficients, const Mat<Dim, T>& U,
                                      const T (&g)[Nodes][Dim], const Sink& sink) {
  Mat<Dim, T> with_first[Nodes];
  for (int a = 0; a < Nodes; ++a)
    for (int r = 0; r < Dim; ++r)
      for (int s = 0; s < Dim; ++s) with_first[a][r][s] = T(0.0);
  for (int a = 1; a < Nodes; ++a)
    for (int b = a; b < Nodes; ++b) {
      const Mat<Dim, T> K = coefficients.block(U, g[a], g[b]);
      sink(a, b, K);
      for (int r = 0; r < Dim; ++r)
        for (int s = 0; s < Dim; ++s) {
          with_first[b][r][s] = with_first[b][r][s] - K[r][s];
          if (a != b) with_first[a][r][s] = with_first[a][r][s] - K[s][r];
        }
    }
  for (int b = 1; b < Nodes; ++b) {
    sink(0, b, with_first[b]);
    for (int r = 0; r < Dim; ++r)
      for (int s = 0; s < Dim; ++s) with_first[0][r][s] = with_first[0][r][s] - with_first[b][r][s];
  }
  for (int r = 0; r < Dim; ++r)
    for (int s = 0; s < r; ++s) with_first[0][r][s] = with_first[0][s][r];  // symmetric to the last bit
  sink(0, 0, with_first[0]);
}

/// Calls sink(a, r, value) for every entry of the gradient of an element of that many nodes, weight P b_a.
/// Node 0, whose entries are minus the sums of the others, comes last.
template <int Dim, class T, class RestGradient, class Sink>
ISOSTRETCH_INLINE void for_each_force(int nodes, const Mat<Dim, T>& P, T weight,
                                      const RestGradient& rest_gradient, const Sink& sink) {
  T first[Dim];
  for (int r = 0; r < Dim; ++r) first[r] = T(0.0);
  for (int a = 1; a < nodes; ++a) {
    T b[Dim];
    for (int c = 0; c < Dim; ++c) b[c] = weight * rest_gradient(a, c);
    for (int r = 0; r < Dim; ++r) {
      T sum = P[r][0] * b[0];
      for (int c = 1; c < Dim; ++c) sum = fma(P[r][c], b[c], sum);
      sink(a, r, sum);
      first[r] = first[r] - sum;
    }
  }
  for (int r = 0; r < Dim; ++r) sink(0, r, first[r]);
}

/// Computes V^T b, the rest gradient b in the frame of V.
template <int Dim, class T>
ISOSTRETCH_INLINE void rotate_gradient(const Mat<Dim, T>& V, const T (&b)[Dim], T (&g)[Dim]) {
  for (int i = 0; i < Dim; ++i) {
    T sum = V[0][i] * b[0];
    for (int k = 1; k < Dim; ++k) sum = fma(V[k][i], b[k], sum);
    g[i] = sum;
  }
}

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch::projection
