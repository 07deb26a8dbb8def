#pragma once

// Kernel templates: Cholesky factorization of dense symmetric positive definite matrices of a few rows,
// A = L L^T, and solutions with L. Entries are reached by functions, so that any layout serves: L(i, j)
// refers to row i, column j. Only the lower triangle, i >= j, is read and written.

#include <isostretch/linalg/matrix.hpp>

namespace isostretch::linalg {
inline namespace ISOSTRETCH_ISA {

/// Replaces the lower triangle of an n x n symmetric matrix by that of its Cholesky factor. L(i, j) refers to
/// row i, column j. Returns the first column without a positive pivot, or -1; with such a column the rest is
/// unfinished.
template <class Entry>
ISOSTRETCH_INLINE int cholesky(int n, const Entry& L) {
  for (int j = 0; j < n; ++j) {
    if (!(L(j, j) > 0)) return j;
    const double pivot = __builtin_sqrt(L(j, j));
    L(j, j) = pivot;
    for (int i = j + 1; i < n; ++i) L(i, j) /= pivot;
    for (int k = j + 1; k < n; ++k)
      for (int i = k; i < n; ++i) L(i, k) -= L(i, j) * L(k, j);
  }
  return -1;
}

/// Replaces the n entries z(i) by the solution y of L y = z, L lower triangular.
template <class Entry, class Right>
ISOSTRETCH_INLINE void solve_lower(int n, const Entry& L, const Right& z) {
  for (int j = 0; j < n; ++j) {
    z(j) /= L(j, j);
    for (int i = j + 1; i < n; ++i) z(i) -= L(i, j) * z(j);
  }
}

/// Replaces the n entries z(i) by the solution y of L^T y = z, L lower triangular.
template <class Entry, class Right>
ISOSTRETCH_INLINE void solve_lower_transposed(int n, const Entry& L, const Right& z) {
  for (int j = n - 1; j >= 0; --j) {
    for (int i = j + 1; i < n; ++i) z(j) -= L(i, j) * z(i);
    z(j) /= L(j, j);
  }
}

/// Makes L the Cholesky factor of A, with zeros above the diagonal. Returns whether A is positive definite; L
/// is unfinished if not.
template <int Dim>
ISOSTRETCH_INLINE bool cholesky(const Mat<Dim>& A, Mat<Dim>& L) {
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) L[i][j] = j <= i ? A[i][j] : 0.0;
  return cholesky(Dim, [&](int i, int j) -> double& { return L[i][j]; }) < 0;
}

/// Returns the inverse of a lower triangular matrix.
template <int Dim>
ISOSTRETCH_INLINE Mat<Dim> inverse_of_lower(const Mat<Dim>& L) {
  Mat<Dim> inverse;
  set_identity(inverse);
  for (int c = 0; c < Dim; ++c)
    solve_lower(
        Dim, [&](int i, int j) { return L[i][j]; }, [&](int i) -> double& { return inverse[i][c]; });
  return inverse;
}

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch::linalg
