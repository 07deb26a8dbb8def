#pragma once

// Kernel template: eigen-decomposition of symmetric Dim x Dim matrices by cyclic Jacobi rotations, for a few
// rows: 2, 3, 4 and 6 are compiled. Users want linalg/decompositions.hpp, and linalg/symmetric_eigen_ql.hpp
// for any number of rows.
//
//   A = Q diag(lambda) Q^T,  Q a rotation,  lambda in no particular order.

#include <isostretch/linalg/svd.hpp>

namespace isostretch::linalg {
inline namespace ISOSTRETCH_ISA {

/// The eigen-decomposition A = Q diag(lambda) Q^T, with a rotation Q and lambda in no particular order.
template <int Dim, class T>
struct SymmetricEigen {
  T lambda[Dim];
  Mat<Dim, T> Q;
};

namespace detail {

/// Zeroes A[p][q] where it matters beside the diagonal (the relative test of Demmel & Veselic, with an
/// absolute floor for indefinite A). Lanes where it does not matter stay untouched.
template <bool WithVectors, int Dim, class T>
ISOSTRETCH_INLINE bool annihilate(Mat<Dim, T>& A, Mat<Dim, T>& Q, int p, int q) {
  const T zero(0.0), one(1.0);
  const T app = A[p][p], aqq = A[q][q], apq = A[p][q];
  const auto matters = (abs(apq) > T(1e-16) * sqrt(abs(app)) * sqrt(abs(aqq))) & (abs(apq) > T(1e-300));
  if (!any(matters)) return false;
  const T d = app - aqq;
  const T h = abs(d) + sqrt(fma(d, d, T(4.0) * apq * apq));
  const T t = select(matters, copysign(T(2.0), d) * apq / select(matters, h, one), zero);
  const T c = one / sqrt(fma(t, t, one));
  const T s = c * t;
  // x_p' = c x_p + s x_q, x_q' = c x_q - s x_p on both sides.
  A[p][p] = fma(t, apq, app);
  A[q][q] = fma(-t, apq, aqq);
  A[p][q] = A[q][p] = select(matters, zero, apq);
  for (int k = 0; k < Dim; ++k) {
    if (k == p || k == q) continue;
    const T kp = A[k][p], kq = A[k][q];
    A[k][p] = A[p][k] = fma(c, kp, s * kq);
    A[k][q] = A[q][k] = fma(c, kq, -(s * kp));
  }
  if constexpr (WithVectors) rotate_columns(Q, p, q, c, s);
  return true;
}

}  // namespace detail

/// Computes the eigen-decomposition of a symmetric matrix by cyclic Jacobi rotations. WithVectors = false
/// leaves Q untouched and unset, for callers that need eigenvalues alone.
template <bool WithVectors = true, int Dim, class T>
ISOSTRETCH_INLINE void symmetric_eigen(const Mat<Dim, T>& matrix, SymmetricEigen<Dim, T>& result) {
  const T scale = detail::exact_scale(matrix);
  const T inverse_scale = T(1.0) / scale;
  Mat<Dim, T> A;
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) A[i][j] = matrix[i][j] * inverse_scale;
  if constexpr (WithVectors) set_identity(result.Q);
  for (int sweep = 0; sweep < detail::max_sweeps; ++sweep) {
    bool rotated = false;
    for (int p = 0; p < Dim; ++p)
      for (int q = p + 1; q < Dim; ++q) rotated |= detail::annihilate<WithVectors>(A, result.Q, p, q);
    if (!rotated) break;
  }
  for (int i = 0; i < Dim; ++i) result.lambda[i] = A[i][i] * scale;
}

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch::linalg
