#pragma once

// The automatic witness: psi(I1, I2, I3) differentiated twice in the entries of F, in long double, without
// eigenvectors. I2 and I3 are polynomials of the entries. I1 = tr S is the largest root p of
//   2D: p^2 = |F|^2 + 2 det F,
//   3D: ((p^2 - I2) / 2)^2 - 2 I3 p - |cof F|^2 = 0,
// the latter because e2 = (p^2 - I2)/2 and e2^2 - 2 p e3 = |cof F|^2 for elementary symmetric e of sigma.
// The derivative of the quartic at its root is 2 (s1 + s2)(s2 + s3)(s3 + s1): simple wherever R is unique.

#include <isostretch/invariants/eigensystem.hpp>
#include <isostretch/testing/automatic_scalar.hpp>

#include <Eigen/Core>

namespace isostretch::testing {

/// The value of an energy at one F, and its gradient and Hessian over vec(F).
template <int Dim>
struct EntryDerivatives {
  double psi = 0;                                       ///< Energy density.
  Eigen::Matrix<double, Dim * Dim, 1> gradient;         ///< Dim^2 entries.
  Eigen::Matrix<double, Dim * Dim, Dim * Dim> hessian;  ///< Dim^2 x Dim^2.
};

/// The scalar of automatic differentiation over the entries of F.
template <int Dim>
using EntryScalar = AutomaticScalar<long double, Dim * Dim>;

namespace detail {

/// Returns f[row + Dim * column], each its own variable.
template <int Dim>
std::array<EntryScalar<Dim>, Dim * Dim> entry_variables(const Eigen::Matrix<double, Dim, Dim>& F) {
  std::array<EntryScalar<Dim>, Dim * Dim> f;
  for (int e = 0; e < Dim * Dim; ++e) f[e] = EntryScalar<Dim>::variable(F.data()[e], e);
  return f;
}

template <class T>
T cofactor(const std::array<T, 9>& f, int row, int column) {
  const int r = (row + 1) % 3, s = (row + 2) % 3, c = 3 * ((column + 1) % 3), d = 3 * ((column + 2) % 3);
  return f[r + c] * f[s + d] - f[s + c] * f[r + d];
}

template <class T>
invariants::Invariants<2, T> invariants_of_entries(const std::array<T, 4>& f, double) {
  const T sum = f[0] + f[3], difference = f[1] - f[2];
  return {sqrt(sum * sum + difference * difference), f[0] * f[0] + f[1] * f[1] + f[2] * f[2] + f[3] * f[3],
          f[0] * f[3] - f[1] * f[2]};
}

/// Returns the invariants by Newton steps in differentiated arithmetic from `start`, I1 in double: each step
/// doubles the digits of the value and raises the order of the derivatives that are right.
template <class T>
invariants::Invariants<3, T> invariants_of_entries(const std::array<T, 9>& f, double start) {
  T I2(0.0), cofactor_norm(0.0), I3(0.0);
  for (int e = 0; e < 9; ++e) I2 = I2 + f[e] * f[e];
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      const T c = cofactor(f, row, column);
      cofactor_norm = cofactor_norm + c * c;
      if (column == 0) I3 = I3 + f[row] * c;
    }
  T p(start);
  for (int step = 0; step < 4; ++step) {
    const T gap = p * p - I2;
    p = p - (gap * gap * 0.25 - 2.0 * I3 * p - cofactor_norm) / (p * gap - 2.0 * I3);
  }
  return {p, I2, I3};
}

}  // namespace detail

/// Returns psi, gradient and Hessian over vec(F) by automatic differentiation in long double.
/// energy.psi(Invariants<Dim, T>) must accept the scalar. F must have a unique rotation (sigma_j + sigma_k >
/// 0).
template <int Dim, class Energy>
EntryDerivatives<Dim> automatic_derivatives(const Energy& energy, const Eigen::Matrix<double, Dim, Dim>& F) {
  const double start = invariants::invariants<Dim>(F).I1;
  const EntryScalar<Dim> psi =
      energy.psi(detail::invariants_of_entries(detail::entry_variables<Dim>(F), start));
  EntryDerivatives<Dim> d;
  d.psi = static_cast<double>(psi.value);
  for (int i = 0; i < Dim * Dim; ++i) {
    d.gradient[i] = static_cast<double>(psi.gradient[i]);
    for (int j = 0; j < Dim * Dim; ++j) d.hessian(i, j) = static_cast<double>(psi.hessian[i * Dim * Dim + j]);
  }
  return d;
}

}  // namespace isostretch::testing
