#pragma once

// Pieces that closed forms of several energies share. Kernel templates, included by every built-in energy.

#include <isostretch/invariants/partials.hpp>

namespace isostretch::energies {

using invariants::first;
using invariants::Invariants;
using invariants::Partials;
using invariants::PrincipalStretches;
using invariants::second;
using invariants::StretchDerivatives;

inline namespace ISOSTRETCH_ISA {

/// Returns log J as a sum of logarithms, since the product could overflow.
template <int Dim, class T>
ISOSTRETCH_INLINE T log_determinant(const PrincipalStretches<Dim, T>& s) {
  T sum = log(s[0]);
  for (int i = 1; i < Dim; ++i) sum = sum + log(s[i]);
  return sum;
}

/// Returns J^(-2/dim).
template <int Dim, class T>
ISOSTRETCH_INLINE T isochoric_factor(const PrincipalStretches<Dim, T>& s) {
  if constexpr (Dim == 2) {
    return 1.0 / s.J();
  } else {
    return square(cbrt(1.0 / s.J()));
  }
}

/// Cube roots of the stretches in 3D, and the excesses of isochoric invariants over their values at rest.
/// Both excesses are sums of squares, from x^3 + y^3 + z^3 - 3xyz = (x + y + z) ((x-y)^2 + (y-z)^2 + (z-x)^2)
/// / 2 with x = sigma^(2/3), so that nothing cancels near a similarity. All stretches must be positive.
template <class T>
struct CubeRoots {
  T root[3];    ///< sigma^(1/3).
  T square[3];  ///< sigma^(2/3).
  T gap[3];     ///< sigma_j^(2/3) - sigma_k^(2/3) of pair i.

  /// Takes the roots of the stretches.
  ISOSTRETCH_INLINE explicit CubeRoots(const PrincipalStretches<3, T>& s) {
    for (int i = 0; i < 3; ++i) root[i] = cbrt(s[i]), square[i] = root[i] * root[i];
    for (int i = 0; i < 3; ++i) {
      const int j = first<3>(i), k = second<3>(i);
      const T denominator = square[j] + root[j] * root[k] + square[k];
      gap[i] = (s[j] - s[k]) * (root[j] + root[k]) / denominator;
    }
  }

  /// Returns |F|^2 J^(-2/3) - 3.
  ISOSTRETCH_INLINE T excess() const {
    const T gaps = gap[0] * gap[0] + gap[1] * gap[1] + gap[2] * gap[2];
    return 0.5 * (square[0] + square[1] + square[2]) * gaps / (square[0] * square[1] * square[2]);
  }

  /// Returns |cof F|^2 J^(-4/3) - 3, the excess of the products of two stretches.
  ISOSTRETCH_INLINE T cofactor_excess() const {
    T sum(0.0), gaps(0.0);
    for (int i = 0; i < 3; ++i) {
      sum = sum + square[first<3>(i)] * square[second<3>(i)];
      const T product_gap = square[i] * gap[i];
      gaps = gaps + product_gap * product_gap;
    }
    const T volume = square[0] * square[1] * square[2];
    return 0.5 * sum * gaps / (volume * volume);
  }
};

/// Returns |F|^2 J^(-2/dim) - dim of positive stretches, without the cancellation of that difference near a
/// similarity.
template <int Dim, class T>
ISOSTRETCH_INLINE T isochoric_excess(const PrincipalStretches<Dim, T>& s) {
  if constexpr (Dim == 2) {
    return square(s[0] - s[1]) / s.J();
  } else {
    return CubeRoots<T>(s).excess();
  }
}

/// Sets psi and all derivatives to zero.
template <int Dim, class T>
ISOSTRETCH_INLINE void set_zero(StretchDerivatives<Dim, T>& d) {
  d.psi = T(0.0);
  for (int i = 0; i < Dim; ++i) d.gradient[i] = d.diagonal[i] = T(0.0);
  for (int i = 0; i < d.pairs; ++i) d.twist[i] = d.flip[i] = d.coupling[i] = T(0.0);
}

/// Multiplies psi and all derivatives, which are linear in psi, by a number.
template <int Dim, class T>
ISOSTRETCH_INLINE void scale_derivatives(double factor, StretchDerivatives<Dim, T>& d) {
  d.psi = factor * d.psi;
  for (int i = 0; i < Dim; ++i)
    d.gradient[i] = factor * d.gradient[i], d.diagonal[i] = factor * d.diagonal[i];
  for (int i = 0; i < d.pairs; ++i) {
    d.twist[i] = factor * d.twist[i];
    d.flip[i] = factor * d.flip[i];
    d.coupling[i] = factor * d.coupling[i];
  }
}

/// Adds the derivatives of a term w(J), given w1 = w'(J) and w2 = w''(J); psi is left to the caller.
template <int Dim, class T>
ISOSTRETCH_INLINE void add_volumetric(const PrincipalStretches<Dim, T>& s, T w1, T w2,
                                      StretchDerivatives<Dim, T>& d) {
  for (int i = 0; i < Dim; ++i) {
    const T g = s.others(i);
    d.gradient[i] = fma(w1, g, d.gradient[i]);
    d.diagonal[i] = fma(w2 * g, g, d.diagonal[i]);
  }
  for (int i = 0; i < d.pairs; ++i) {
    const T c = s.c(i) * w1;
    d.twist[i] = d.twist[i] + c;
    d.flip[i] = d.flip[i] - c;
    d.coupling[i] = d.coupling[i] + fma(w2 * s.others(first<Dim>(i)), s.others(second<Dim>(i)), c);
  }
}

/// Computes the derivatives of h(y) + K/2 (J - 1)^2 with y = |F|^2 J^(-2/dim), given h1 = h'(y) and h2 =
/// h''(y).
template <int Dim, class T>
ISOSTRETCH_INLINE void isochoric_derivatives(const PrincipalStretches<Dim, T>& s, T h1, T h2, double K,
                                             StretchDerivatives<Dim, T>& d) {
  constexpr double p = 2.0 / Dim;
  const T v = isochoric_factor(s), I2 = s.I2();
  T r[Dim], dy[Dim];
  for (int i = 0; i < Dim; ++i) {
    r[i] = 1.0 / s[i];
    // 2 sigma - p I2 / sigma = p sum_j (sigma_i^2 - sigma_j^2) / sigma_i, as differences of squares.
    T spread(0.0);
    for (int j = 0; j < Dim; ++j)
      if (j != i) spread = spread + (s[i] - s[j]) * (s[i] + s[j]);
    dy[i] = v * p * spread * r[i];
    d.gradient[i] = h1 * dy[i];
    d.diagonal[i] = h1 * v * ((2.0 - 4.0 * p) + p * (p + 1.0) * I2 * r[i] * r[i]) + h2 * dy[i] * dy[i];
  }
  for (int i = 0; i < d.pairs; ++i) {
    const int j = first<Dim>(i), k = second<Dim>(i);
    const T pq = r[j] * r[k], squares = s[j] * s[j] + s[k] * s[k];
    if constexpr (Dim == 2) {
      d.twist[i] = -h1 * v * square(s[j] - s[k]) * pq;
    } else {
      d.twist[i] = h1 * v * p * (product_difference(s[j], s[k], s.c(i), s.c(i)) - square(s[j] - s[k])) * pq;
    }
    d.flip[i] = h1 * v * (2.0 + p * I2 * pq);
    d.coupling[i] = h1 * v * p * (p * I2 - 2.0 * squares) * pq + h2 * dy[j] * dy[k];
  }
  add_volumetric(s, K * s.J_minus_one(), T(K), d);
}

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch::energies
