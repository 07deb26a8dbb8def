#pragma once

#include <isostretch/invariants/stretch.hpp>
#include <isostretch/linalg/symmetric_eigen_ql.hpp>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <limits>

namespace isostretch::baselines {

template <int Dim>
using ScalingMatrix = Eigen::Matrix<double, Dim, Dim>;

// The scaling block A of the Hessian, out of and back into its entries.
template <int Dim>
ScalingMatrix<Dim> scaling_matrix(const invariants::StretchDerivatives<Dim, double>& d) {
  ScalingMatrix<Dim> A;
  for (int i = 0; i < Dim; ++i) A(i, i) = d.diagonal[i];
  for (int i = 0; i < d.pairs; ++i) {
    const int j = invariants::first<Dim>(i), k = invariants::second<Dim>(i);
    A(j, k) = A(k, j) = d.coupling[i];
  }
  return A;
}

template <int Dim>
void set_scaling_matrix(const ScalingMatrix<Dim>& A, invariants::StretchDerivatives<Dim, double>& d) {
  for (int i = 0; i < Dim; ++i) d.diagonal[i] = A(i, i);
  for (int i = 0; i < d.pairs; ++i) d.coupling[i] = A(invariants::first<Dim>(i), invariants::second<Dim>(i));
}

// The nearest positive semi-definite matrix, by an eigen-decomposition that was computed.
template <class Solver>
auto clamped(const Solver& eigen) {
  const auto& Q = eigen.eigenvectors();
  return (Q * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() * Q.transpose()).eval();
}

// The same of n x n numbers in place, by the iterative decomposition; not numbers if that fails.
template <int Capacity>
void clamp_to_semidefinite(double* A, int n) {
  const linalg::SymmetricEigenQl<Capacity> eigen(A, n);
  std::fill(A, A + n * n, eigen.converged() ? 0.0 : std::numeric_limits<double>::quiet_NaN());
  if (!eigen.converged()) return;
  for (int k = 0; k < n; ++k) {
    if (!(eigen.value(k) > 0)) continue;
    const double* v = eigen.vector(k);
    for (int i = 0; i < n; ++i) {
      const double factor = eigen.value(k) * v[i];
      for (int j = 0; j < n; ++j) A[i * n + j] += factor * v[j];
    }
  }
}

template <int Size>
Eigen::Matrix<double, Size, Size> nearest_semidefinite(Eigen::Matrix<double, Size, Size> A) {
  clamp_to_semidefinite<Size>(A.data(), Size);
  return A;
}

}  // namespace isostretch::baselines
