#pragma once

// The invariants themselves as functions of F: values, gradients, Hessians and the eigensystems of those, and
// the gradient of the rotation. One matrix at a time, with Eigen types; everything is vec'ed column by
// column, vec(F) = (F00, F10, ...). Smith, de Goes, Kim 2019, sections 3 and 4 and appendix B.

#include <isostretch/invariants/stretch.hpp>
#include <isostretch/linalg/decompositions.hpp>

#include <Eigen/Core>

#include <cmath>

namespace isostretch::invariants {
inline namespace ISOSTRETCH_ISA {

/// A deformation gradient or another Dim x Dim matrix.
template <int Dim>
using MatrixD = Eigen::Matrix<double, Dim, Dim>;
/// A vec'ed Dim x Dim matrix, column by column: Dim^2 entries.
template <int Dim>
using VectorD2 = Eigen::Matrix<double, Dim * Dim, 1>;
/// A matrix that maps vec'ed matrices, Dim^2 x Dim^2.
template <int Dim>
using MatrixD2 = Eigen::Matrix<double, Dim * Dim, Dim * Dim>;

/// Returns the entries of M column by column: vec(M) = (M00, M10, ...).
template <int Dim>
VectorD2<Dim> vec(const MatrixD<Dim>& M) {
  return Eigen::Map<const VectorD2<Dim>>(M.data());
}

/// The modes that all isotropic energies share at one F: unit and mutually orthogonal vec'ed matrices (Smith,
/// de Goes, Kim 2019, section 4).
template <int Dim>
struct Modes {
  linalg::SignedSvd<Dim> svd;  ///< F = U diag(sigma) V^T.

  /// Decomposes F.
  explicit Modes(const MatrixD<Dim>& F) : svd(linalg::signed_svd<Dim>(F)) {}

  /// Returns the twist of a pair: vec(U A V^T) / sqrt 2, A antisymmetric in the plane of the pair.
  VectorD2<Dim> twist(int pair) const { return planar(pair, -1.0); }
  /// Returns the flip of a pair: vec(U A V^T) / sqrt 2, A symmetric in the plane of the pair, with a zero
  /// diagonal.
  VectorD2<Dim> flip(int pair) const { return planar(pair, 1.0); }
  /// Returns scaling mode i: vec(U e_i e_i^T V^T).
  VectorD2<Dim> scaling(int i) const { return vec<Dim>(svd.U.col(i) * svd.V.col(i).transpose()); }
  /// Returns the rotation R = U V^T of the polar decomposition.
  MatrixD<Dim> rotation() const { return svd.U * svd.V.transpose(); }

  /// Returns the signed singular values.
  PrincipalStretches<Dim, double> stretch() const {
    PrincipalStretches<Dim, double> s;
    for (int i = 0; i < Dim; ++i) s.sigma[i] = svd.sigma[i];
    return s;
  }

 private:
  VectorD2<Dim> planar(int pair, double sign) const {
    const int j = first<Dim>(pair), k = second<Dim>(pair);
    const MatrixD<Dim> M =
        sign * svd.U.col(j) * svd.V.col(k).transpose() + svd.U.col(k) * svd.V.col(j).transpose();
    return vec<Dim>(M) / std::sqrt(2.0);
  }
};

/// Returns the invariants I1, I2, I3 of the stretch of F.
template <int Dim>
Invariants<Dim, double> invariants(const MatrixD<Dim>& F) {
  return Modes<Dim>(F).stretch().invariants();
}

/// Returns R = d I1 / d F, Dim x Dim.
template <int Dim>
MatrixD<Dim> gradient_I1(const MatrixD<Dim>& F) {
  return Modes<Dim>(F).rotation();
}

/// Returns 2 F = d I2 / d F, Dim x Dim.
template <int Dim>
MatrixD<Dim> gradient_I2(const MatrixD<Dim>& F) {
  return 2.0 * F;
}

/// Returns the cofactor matrix of F, d I3 / d F, Dim x Dim.
template <int Dim>
MatrixD<Dim> gradient_I3(const MatrixD<Dim>& F) {
  MatrixD<Dim> C;
  if constexpr (Dim == 2) {
    C << F(1, 1), -F(1, 0), -F(0, 1), F(0, 0);
  } else {
    for (int j = 0; j < 3; ++j) {
      const int k = (j + 1) % 3, l = (j + 2) % 3;
      for (int i = 0; i < 3; ++i) {
        const int m = (i + 1) % 3, n = (i + 2) % 3;
        C(i, j) = F(m, k) * F(n, l) - F(m, l) * F(n, k);
      }
    }
  }
  return C;
}

/// Returns the rotation gradient d vec(R) / d vec(F), which is also the Hessian of I1: eigenvalue 2 /
/// (sigma_j + sigma_k) on each twist, zero elsewhere (Smith, de Goes, Kim 2019, Eqs. 10-13). Bounded as
/// PrincipalStretches::safe_sum says where R is not unique.
template <int Dim>
MatrixD2<Dim> rotation_gradient(const MatrixD<Dim>& F) {
  const Modes<Dim> modes(F);
  const auto stretch = modes.stretch();
  MatrixD2<Dim> H = MatrixD2<Dim>::Zero();
  for (int i = 0; i < pair_count<Dim>; ++i) {
    const VectorD2<Dim> t = modes.twist(i);
    H += 2.0 / stretch.safe_sum(i) * t * t.transpose();
  }
  return H;
}

/// Returns the Hessian of I1 over vec(F), the rotation gradient.
template <int Dim>
MatrixD2<Dim> hessian_I1(const MatrixD<Dim>& F) {
  return rotation_gradient<Dim>(F);
}

/// Returns the Hessian of I2 over vec(F), 2 I.
template <int Dim>
MatrixD2<Dim> hessian_I2(const MatrixD<Dim>&) {
  return 2.0 * MatrixD2<Dim>::Identity();
}

/// Returns the Hessian of I3 over vec(F): eigenvalues sigma_i on twist_i, -sigma_i on flip_i (1 and -1 in
/// 2D), and the scaling block with sigma_k at (i, j) (Smith, de Goes, Kim 2019, Eqs. 15-18). It is assembled
/// without a decomposition, as the constant or linear function of F that it is.
template <int Dim>
MatrixD2<Dim> hessian_I3(const MatrixD<Dim>& F) {
  MatrixD2<Dim> H = MatrixD2<Dim>::Zero();
  if constexpr (Dim == 2) {
    H(0, 3) = H(3, 0) = 1.0;
    H(1, 2) = H(2, 1) = -1.0;
  } else {
    for (int a = 0; a < 3; ++a)
      for (int i = 0; i < 3; ++i) {
        // d cof(i, a) / d F(m, b) = eps(i, m, n) eps(a, b, c) F(n, c).
        for (int step = 1; step <= 2; ++step)
          for (int turn = 1; turn <= 2; ++turn) {
            const int m = (i + step) % 3, n = (i + 3 - step) % 3;
            const int b = (a + turn) % 3, c = (a + 3 - turn) % 3;
            const double sign = step == turn ? 1.0 : -1.0;
            H(i + 3 * a, m + 3 * b) = sign * F(n, c);
          }
      }
  }
  return H;
}

/// The invariants of the right Cauchy-Green tensor C = F^T F: I_C = tr C, II_C = |C|^2, III_C = det C (Smith,
/// de Goes, Kim 2019, appendix A, whose label on the second is misprinted).
struct CauchyGreenInvariants {
  double I_C;    ///< tr C.
  double II_C;   ///< |C|^2.
  double III_C;  ///< det C.
};

/// Returns the invariants of the right Cauchy-Green tensor that belong to I1, I2, I3.
template <int Dim>
CauchyGreenInvariants cauchy_green(const Invariants<Dim, double>& I) {
  if constexpr (Dim == 2) return {I.I2, I.I2 * I.I2 - 2.0 * I.I3 * I.I3, I.I3 * I.I3};
  const double squared = I.I1 * I.I1;
  return {I.I2, 0.5 * I.I2 * I.I2 - 0.5 * squared * squared + squared * I.I2 + 4.0 * I.I1 * I.I3,
          I.I3 * I.I3};
}

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch::invariants
