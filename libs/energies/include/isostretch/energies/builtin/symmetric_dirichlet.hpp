#pragma once

#include <isostretch/energies/forms.hpp>

namespace isostretch::energies {

/// The symmetric Dirichlet energy: psi = weight (|F|^2 + |F^-1|^2). weight = 1 is the convention of the
/// parameterization literature, with minimum 2 dim; weight = 1/2 is that of Smith, de Goes, Kim 2019, Eqs.
/// 34, 35, whose forms lose every digit of the 3D twist at extreme stretch: the ones here, in sigma, do not.
/// Infinite at det F <= 0. Only twists can be negative.
struct SymmetricDirichlet {
  static constexpr const char* name = "symmetric_dirichlet";
  static constexpr double minimum_determinant = 0.0;
  static constexpr bool decoupled = true;

  double weight = 1.0;  ///< Factor, in the units of psi.

  template <class Visitor>
  void parameters(Visitor&& visit) {
    visit("weight", weight, "1: |F|^2 + |F^-1|^2; 0.5: half of it");
  }

  template <class Require>
  void require_parameters(Require&& require) const {
    require("weight", weight >= 0, "must not be negative");
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const Invariants<Dim, T>& I) const {
    if constexpr (Dim == 2) {
      return weight * (I.I2 + I.I2 / square(I.I3));
    } else {
      const T E2 = 0.5 * (square(I.I1) - I.I2);
      return weight * (I.I2 + square(E2 / I.I3) - 2.0 * I.I1 / I.I3);
    }
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE Partials<T> partials(const Invariants<Dim, T>& I) const {
    Partials<T> p(psi(I));
    const T w = T(2.0 * weight), r = 1.0 / I.I3, r2 = r * r;
    if constexpr (Dim == 2) {
      p.P2 = 0.5 * w * (1.0 + r2);
      p.P3 = -w * I.I2 * r * r2;
      p.P33 = 3.0 * w * I.I2 * r2 * r2;
      p.P23 = -w * r * r2;
    } else {
      const T E2 = 0.5 * (square(I.I1) - I.I2);
      p.P1 = w * (I.I1 * E2 - I.I3) * r2;
      p.P2 = w * (0.5 - 0.5 * E2 * r2);
      p.P3 = w * (I.I1 * I.I3 - E2 * E2) * r * r2;
      p.P11 = w * (E2 + square(I.I1)) * r2;
      p.P22 = w * 0.25 * r2;
      p.P33 = w * (3.0 * E2 * E2 - 2.0 * I.I1 * I.I3) * r2 * r2;
      p.P12 = -0.5 * w * I.I1 * r2;
      p.P23 = w * E2 * r * r2;
      p.P13 = w * (I.I3 - 2.0 * I.I1 * E2) * r * r2;
    }
    return p;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const PrincipalStretches<Dim, T>& s) const {
    T sum = square(s[0]) + square(1.0 / s[0]);
    for (int i = 1; i < Dim; ++i) sum = sum + square(s[i]) + square(1.0 / s[i]);
    return weight * sum;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE void derivatives(const PrincipalStretches<Dim, T>& s,
                                     StretchDerivatives<Dim, T>& d) const {
    const double w = 2.0 * weight;
    T r[Dim];
    T sum(0.0);
    for (int i = 0; i < Dim; ++i) {
      r[i] = 1.0 / s[i];
      const T r2 = r[i] * r[i];
      sum = sum + fma(s[i], s[i], r2);
      // sigma - sigma^-3 without its cancellation at rest.
      d.gradient[i] = w * ((s[i] - 1.0) * (s[i] + 1.0)) * ((1.0 + r2) * r[i]);
      d.diagonal[i] = w * fma(3.0 * r2, r2, T(1.0));
    }
    d.psi = weight * sum;
    for (int i = 0; i < s.pairs; ++i) {
      const T a = s.a(i), b = s.b(i), p = r[first<Dim>(i)], q = r[second<Dim>(i)];
      const T pq = p * q, stretch_gap = (a - b) * pq;
      d.twist[i] =
          w * (product_difference(a, b, T(1.0), T(1.0)) * pq * (1.0 + pq) - stretch_gap * stretch_gap * pq);
      d.flip[i] = w * (1.0 + pq * (p * p + pq + q * q));
    }
    d.set_decoupled();
  }
};

}  // namespace isostretch::energies
