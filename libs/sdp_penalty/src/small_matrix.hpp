#pragma once

// Matrices of 2x2 and 3x3 on the stack, row by row: no Eigen, whose alignment depends on compiler flags.

#include <array>
#include <cmath>
#include <cstddef>

namespace isostretch::sdp_penalty {

// Loops over fewer elements than this are over before other threads have woken up: measured, threads that
// sleep between loops pay from some 8000 triangles on, threads that spin from 3000.
inline constexpr std::size_t least_parallel = 4000;

template <int D>
struct Small {
  std::array<double, static_cast<std::size_t>(D* D)> entry{};

  double& operator()(int r, int c) { return entry[static_cast<std::size_t>(r * D + c)]; }
  double operator()(int r, int c) const { return entry[static_cast<std::size_t>(r * D + c)]; }
};

template <int D>
Small<D> load(const double* p) {
  Small<D> A;
  for (std::size_t k = 0; k < A.entry.size(); ++k) A.entry[k] = p[k];
  return A;
}

template <int D>
void store(const Small<D>& A, double* p) {
  for (std::size_t k = 0; k < A.entry.size(); ++k) p[k] = A.entry[k];
}

template <int D>
Small<D> identity(double scale = 1) {
  Small<D> A;
  for (int i = 0; i < D; ++i) A(i, i) = scale;
  return A;
}

template <int D>
Small<D> operator*(const Small<D>& A, const Small<D>& B) {
  Small<D> C;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
      for (int k = 0; k < D; ++k) C(i, j) += A(i, k) * B(k, j);
  return C;
}

template <int D>
Small<D> transposed(const Small<D>& A) {
  Small<D> B;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) B(i, j) = A(j, i);
  return B;
}

template <int D>
Small<D> symmetric_part(const Small<D>& A) {
  Small<D> B;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) B(i, j) = 0.5 * (A(i, j) + A(j, i));
  return B;
}

template <int D>
double dot(const Small<D>& A, const Small<D>& B) {
  double sum = 0;
  for (std::size_t k = 0; k < A.entry.size(); ++k) sum += A.entry[k] * B.entry[k];
  return sum;
}

template <int D>
double determinant(const Small<D>& A) {
  if constexpr (D == 2)
    return A(0, 0) * A(1, 1) - A(0, 1) * A(1, 0);
  else
    return A(0, 0) * (A(1, 1) * A(2, 2) - A(1, 2) * A(2, 1)) -
           A(0, 1) * (A(1, 0) * A(2, 2) - A(1, 2) * A(2, 0)) +
           A(0, 2) * (A(1, 0) * A(2, 1) - A(1, 1) * A(2, 0));
}

// Lower triangular L with L L^T = A; false where a pivot is not positive.
template <int D>
bool cholesky(const Small<D>& A, Small<D>& L) {
  L = {};
  for (int j = 0; j < D; ++j) {
    double pivot = A(j, j);
    for (int k = 0; k < j; ++k) pivot -= L(j, k) * L(j, k);
    if (!(pivot > 0)) return false;
    L(j, j) = std::sqrt(pivot);
    for (int i = j + 1; i < D; ++i) {
      double sum = A(i, j);
      for (int k = 0; k < j; ++k) sum -= L(i, k) * L(j, k);
      L(i, j) = sum / L(j, j);
    }
  }
  return true;
}

}  // namespace isostretch::sdp_penalty
