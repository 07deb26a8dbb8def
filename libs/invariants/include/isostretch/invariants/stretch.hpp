#pragma once

// Singular values of a deformation gradient and what an isotropic energy is a function of: the invariants of
// the stretch tensor S of F = R S (Smith, de Goes, Kim 2019, Eq. 6),
//
//   I1 = tr S = sum sigma,   I2 = |S|^2 = sum sigma^2,   I3 = det S = det F = prod sigma.
//
// Kernel templates over T = double, Pack or Jet2.

#include <isostretch/invariants/scalar_functions.hpp>

namespace isostretch::invariants {
inline namespace ISOSTRETCH_ISA {

/// The invariants of the stretch S of F = R S: I1 = tr S, I2 = |S|^2, I3 = det S = det F (Smith, de Goes, Kim
/// 2019, Eq. 6).
template <int Dim, class T>
struct Invariants {
  static constexpr int dim = Dim;  ///< Dimension, 2 or 3.
  T I1;                            ///< tr S, the sum of the singular values.
  T I2;                            ///< |S|^2, the sum of their squares.
  T I3;                            ///< det F.
};

/// The number of pairs of singular values, each of which spans a plane of rotation.
template <int Dim>
inline constexpr int pair_count = Dim == 3 ? 3 : 1;

/// Returns the first axis of a pair; in 3D the axis outside pair i is axis i.
template <int Dim>
ISOSTRETCH_INLINE constexpr int first(int pair) {
  return Dim == 3 ? (pair + 1) % 3 : 0;
}

/// Returns the second axis of a pair; in 3D the axis outside pair i is axis i.
template <int Dim>
ISOSTRETCH_INLINE constexpr int second(int pair) {
  return Dim == 3 ? (pair + 2) % 3 : 1;
}

/// The signed singular values of a deformation gradient, as linalg::signed_svd gives them: sigma_0 >= ... >=
/// |sigma_last|.
template <int Dim, class T>
struct PrincipalStretches {
  static constexpr int dim = Dim;                ///< Dimension, 2 or 3.
  static constexpr int pairs = pair_count<Dim>;  ///< Number of pairs: 1 in 2D, 3 in 3D.
  T sigma[Dim];                                  ///< The singular values, the sign of det F in the last.

  /// Returns sigma_i.
  ISOSTRETCH_INLINE T operator[](int i) const { return sigma[i]; }
  /// Returns the first singular value of the pair.
  ISOSTRETCH_INLINE T a(int pair) const { return sigma[first<Dim>(pair)]; }
  /// Returns the second singular value of the pair.
  ISOSTRETCH_INLINE T b(int pair) const { return sigma[second<Dim>(pair)]; }
  /// Returns the singular value outside the pair; 1 in 2D, with which every formula of 3D holds.
  ISOSTRETCH_INLINE T c(int pair) const {
    if constexpr (Dim == 3) return sigma[pair];
    return T(1.0);
  }
  /// Returns the product of the singular values of the pair.
  ISOSTRETCH_INLINE T product(int pair) const { return a(pair) * b(pair); }

  /// Returns the product of all singular values but the i-th, d(det F) / d(sigma_i), without a division.
  ISOSTRETCH_INLINE T others(int i) const {
    if constexpr (Dim == 3) return sigma[(i + 1) % 3] * sigma[(i + 2) % 3];
    return sigma[1 - i];
  }

  /// Returns I1, the sum of singular values.
  ISOSTRETCH_INLINE T I1() const {
    if constexpr (Dim == 3) return sigma[0] + sigma[1] + sigma[2];
    return sigma[0] + sigma[1];
  }
  /// Returns I2, the sum of squares.
  ISOSTRETCH_INLINE T I2() const {
    T sum = sigma[0] * sigma[0];
    for (int i = 1; i < Dim; ++i) sum = sum + sigma[i] * sigma[i];
    return sum;
  }
  /// Returns det F.
  ISOSTRETCH_INLINE T J() const { return others(0) * sigma[0]; }

  /// Returns sum (sigma - 1), without the cancellation of I1 - dim near rest.
  ISOSTRETCH_INLINE T I1_minus_dim() const {
    T sum = sigma[0] - T(1.0);
    for (int i = 1; i < Dim; ++i) sum = sum + (sigma[i] - T(1.0));
    return sum;
  }
  /// Returns sum (sigma^2 - 1), without the cancellation of I2 - dim near rest.
  ISOSTRETCH_INLINE T I2_minus_dim() const {
    T sum = (sigma[0] - T(1.0)) * (sigma[0] + T(1.0));
    for (int i = 1; i < Dim; ++i) sum = sum + (sigma[i] - T(1.0)) * (sigma[i] + T(1.0));
    return sum;
  }
  /// Returns det F - 1 to a rounding or two of itself: near rest, where 1 cancels, and at any aspect ratio,
  /// where the expansion in sigma - 1 would cancel.
  ISOSTRETCH_INLINE T J_minus_one() const {
    const T one(1.0);
    if constexpr (Dim == 2) {
      return product_difference(sigma[0], sigma[1], one, one);
    } else {
      const T p = sigma[0] * sigma[1];
      const T rounding = product_difference(sigma[0], sigma[1], p, one);
      return product_difference(p, sigma[2], one, one) + rounding * sigma[2];
    }
  }

  /// Returns sigma_i - others(i), which is zero at rest, without cancellation near rest.
  ISOSTRETCH_INLINE T minus_others(int i) const {
    if constexpr (Dim == 2) {
      return sigma[i] - sigma[1 - i];
    } else {
      return product_difference(sigma[i], T(1.0), sigma[(i + 1) % 3], sigma[(i + 2) % 3]);
    }
  }

  /// Returns sigma_j + sigma_k of a pair, bounded from below. It is the only denominator of the theory that
  /// is not an artefact: it vanishes on inverted F with equal magnitudes and on F of rank below dim - 1,
  /// where R is not unique and an energy that depends on I1 has a kink. The bound, relative to the largest
  /// sigma, makes the twist eigenvalue there huge and of the right sign instead of infinite: a filter then
  /// does what the limit would.
  ISOSTRETCH_INLINE T safe_sum(int pair) const {
    const T floor = max(T(sum_floor) * sigma[0], T(sum_floor_absolute));
    return max(a(pair) + b(pair), floor);
  }

  /// Returns I1, I2 and I3.
  ISOSTRETCH_INLINE Invariants<Dim, T> invariants() const { return {I1(), I2(), J()}; }

  static constexpr double sum_floor = 1e-12;  ///< The least sum of a pair, relative to the largest sigma.
  static constexpr double sum_floor_absolute = 1e-100;  ///< The least sum of a pair.
};

/// The value and the derivatives of an energy at one stretch, in the frame of the singular vectors: all that
/// the pipeline needs. With A the Hessian of psi as a function of sigma, the Hessian over F is (Smith, de
/// Goes, Kim 2019, section 4)
///   sum_i twist_i t_i t_i^T + flip_i l_i l_i^T + sum_ij A_ij d_i d_j^T.
template <int Dim, class T>
struct StretchDerivatives {
  static constexpr int pairs = pair_count<Dim>;  ///< Number of pairs: 1 in 2D, 3 in 3D.
  T psi;                                         ///< The energy density.
  T gradient[Dim];    ///< d psi / d sigma_i, the principal first Piola-Kirchhoff stresses.
  T twist[pairs];     ///< The eigenvalue of each pair's twist.
  T flip[pairs];      ///< The eigenvalue of each pair's flip.
  T diagonal[Dim];    ///< A_ii.
  T coupling[pairs];  ///< A_jk of pair i.

  /// Sets the off-diagonal entries of A to zero.
  ISOSTRETCH_INLINE void set_decoupled() {
    for (int i = 0; i < pairs; ++i) coupling[i] = T(0.0);
  }
};

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch::invariants
