#pragma once

// Kernel templates: square matrices on the stack and what is computed with them, for T = double or Pack. No
// Eigen, whose alignment depends on compiler flags and whose functions have external linkage.

#include <isostretch/core/pack.hpp>

namespace isostretch::linalg {
inline namespace ISOSTRETCH_ISA {

/// A Dim x Dim matrix on the stack: m[i][j] is row i, column j. `Mat<3> A{}` is zero, `Mat<3> A` has no
/// values yet.
template <int Dim, class T = double>
struct Mat {
  T m[Dim][Dim];
  /// Returns row i.
  ISOSTRETCH_INLINE T* operator[](int i) { return m[i]; }
  /// Returns row i.
  ISOSTRETCH_INLINE const T* operator[](int i) const { return m[i]; }
};

/// Makes M the identity.
template <int Dim, class T>
ISOSTRETCH_INLINE void set_identity(Mat<Dim, T>& M) {
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) M[i][j] = T(i == j ? 1.0 : 0.0);
}

/// Returns the matrix whose Dim * Dim entries stand at p row by row.
template <int Dim>
ISOSTRETCH_INLINE Mat<Dim> from_rows(const double* p) {
  Mat<Dim> A;
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) A[i][j] = p[i * Dim + j];
  return A;
}

/// Returns the matrix whose Dim * Dim entries stand at p column by column, as vec(F) has them.
template <int Dim>
ISOSTRETCH_INLINE Mat<Dim> from_columns(const double* p) {
  Mat<Dim> A;
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) A[i][j] = p[i + Dim * j];
  return A;
}

/// Writes the Dim * Dim entries of A to p row by row.
template <int Dim>
ISOSTRETCH_INLINE void to_rows(const Mat<Dim>& A, double* p) {
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) p[i * Dim + j] = A[i][j];
}

/// Returns A B.
template <int Dim, class T>
ISOSTRETCH_INLINE Mat<Dim, T> operator*(const Mat<Dim, T>& A, const Mat<Dim, T>& B) {
  Mat<Dim, T> C;
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) {
      T sum = A[i][0] * B[0][j];
      for (int k = 1; k < Dim; ++k) sum = fma(A[i][k], B[k][j], sum);
      C[i][j] = sum;
    }
  return C;
}

/// Adds B to A, entry by entry.
template <int Dim, class T>
ISOSTRETCH_INLINE Mat<Dim, T>& operator+=(Mat<Dim, T>& A, const Mat<Dim, T>& B) {
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) A[i][j] = A[i][j] + B[i][j];
  return A;
}

/// Multiplies every entry of A by a number.
template <int Dim, class T>
ISOSTRETCH_INLINE Mat<Dim, T>& operator*=(Mat<Dim, T>& A, T factor) {
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) A[i][j] = A[i][j] * factor;
  return A;
}

/// Returns A^T.
template <int Dim, class T>
ISOSTRETCH_INLINE Mat<Dim, T> transposed(const Mat<Dim, T>& A) {
  Mat<Dim, T> B;
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) B[i][j] = A[j][i];
  return B;
}

/// Returns (A + A^T) / 2.
template <int Dim, class T>
ISOSTRETCH_INLINE Mat<Dim, T> symmetric_part(const Mat<Dim, T>& A) {
  Mat<Dim, T> B;
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) B[i][j] = T(0.5) * (A[i][j] + A[j][i]);
  return B;
}

/// Returns tr(A^T B), the sum of products of corresponding entries.
template <int Dim, class T>
ISOSTRETCH_INLINE T inner_product(const Mat<Dim, T>& A, const Mat<Dim, T>& B) {
  T sum(0.0);
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) sum = fma(A[i][j], B[i][j], sum);
  return sum;
}

/// Returns the cofactor matrix of a 2 x 2 or 3 x 3 matrix, the derivative of its determinant.
template <int Dim, class T>
ISOSTRETCH_INLINE Mat<Dim, T> cofactor(const Mat<Dim, T>& A) {
  static_assert(Dim == 2 || Dim == 3);
  Mat<Dim, T> C;
  if constexpr (Dim == 2) {
    C[0][0] = A[1][1], C[0][1] = -A[1][0];
    C[1][0] = -A[0][1], C[1][1] = A[0][0];
  } else {
    for (int c = 0; c < 3; ++c)
      for (int r = 0; r < 3; ++r) {
        const int i = (r + 1) % 3, j = (r + 2) % 3, k = (c + 1) % 3, l = (c + 2) % 3;
        C[r][c] = A[i][k] * A[j][l] - A[i][l] * A[j][k];
      }
  }
  return C;
}

/// Returns the determinant of a 2 x 2 or 3 x 3 matrix.
template <int Dim, class T>
ISOSTRETCH_INLINE T determinant(const Mat<Dim, T>& A) {
  static_assert(Dim == 2 || Dim == 3);
  if constexpr (Dim == 2)
    return A[0][0] * A[1][1] - A[0][1] * A[1][0];
  else
    return A[0][0] * (A[1][1] * A[2][2] - A[1][2] * A[2][1]) -
           A[0][1] * (A[1][0] * A[2][2] - A[1][2] * A[2][0]) +
           A[0][2] * (A[1][0] * A[2][1] - A[1][1] * A[2][0]);
}

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch::linalg
