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
#include <isostretch/linalg/svd.hpp>

namespace isostretch::projection {
inline namespace ISOSTRETCH_ISA {

using linalg::Mat;

// P = d psi / d F = U diag(d psi / d sigma) V^T.
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

// The Hessian in the singular frame: A, p and q above, multiplied by a weight.
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

  // U M U^T for rest gradients g, h in the frame of V.
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

// b in the frame of V: V^T b.
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
