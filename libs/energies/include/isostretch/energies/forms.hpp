#pragma once

// Pieces that closed forms of several energies share. Kernel templates, included by every built-in energy.

#include <isostretch/invariants/partials.hpp>

namespace isostretch::energies {

using invariants::first;
using invariants::Invariants;
using invariants::Partials;
using invariants::second;
using invariants::Stretch;
using invariants::StretchDerivatives;

inline namespace ISOSTRETCH_ISA {

// log J as a sum: the product could overflow.
template <int Dim, class T>
ISOSTRETCH_INLINE T log_determinant(const Stretch<Dim, T>& s) {
  T sum = log(s[0]);
  for (int i = 1; i < Dim; ++i) sum = sum + log(s[i]);
  return sum;
}

// J^(-2/dim).
template <int Dim, class T>
ISOSTRETCH_INLINE T isochoric_factor(const Stretch<Dim, T>& s) {
  if constexpr (Dim == 2) {
    return 1.0 / s.J();
  } else {
    return square(cbrt(1.0 / s.J()));
  }
}

template <int Dim, class T>
ISOSTRETCH_INLINE void set_zero(StretchDerivatives<Dim, T>& d) {
  d.psi = T(0.0);
  for (int i = 0; i < Dim; ++i) d.gradient[i] = d.diagonal[i] = T(0.0);
  for (int i = 0; i < d.pairs; ++i) d.twist[i] = d.flip[i] = d.coupling[i] = T(0.0);
}

// All eigen-data are linear in psi.
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

// Adds the derivatives of a term w(J), w1 = w'(J) and w2 = w''(J); psi is left to the caller.
template <int Dim, class T>
ISOSTRETCH_INLINE void add_volumetric(const Stretch<Dim, T>& s, T w1, T w2, StretchDerivatives<Dim, T>& d) {
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

// Derivatives of h(y) + K/2 (J - 1)^2 with y = |F|^2 J^(-2/dim), h1 = h'(y), h2 = h''(y).
template <int Dim, class T>
ISOSTRETCH_INLINE void isochoric_derivatives(const Stretch<Dim, T>& s, T h1, T h2, double K,
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
