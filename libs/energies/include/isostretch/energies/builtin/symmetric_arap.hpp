#pragma once

#include <isostretch/energies/forms.hpp>

namespace isostretch::energies {

/// The symmetric ARAP energy: psi = mu/2 (|F - R|^2 + |F^-1 - R^-1|^2) = mu/2 sum (sigma - 1)^2 + (1/sigma -
/// 1)^2 (Smith, de Goes, Kim 2019, appendix F.2, where the constant must be + mu dim). Infinite at det F <=
/// 0. Only twists can be negative.
struct SymmetricArap {
  static constexpr const char* name = "symmetric_arap";
  static constexpr double minimum_determinant = 0.0;
  static constexpr bool decoupled = true;

  double mu = 1.0;  ///< Stiffness, in the units of psi.

  template <class Visitor>
  void parameters(Visitor&& visit) {
    visit("mu", mu, "stiffness");
  }

  template <class Require>
  void require_parameters(Require&& require) const {
    require("mu", mu >= 0, "must not be negative");
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const Invariants<Dim, T>& I) const {
    if constexpr (Dim == 2) {
      return mu * (0.5 * I.I2 - I.I1 + 0.5 * I.I2 / square(I.I3) - I.I1 / I.I3 + 2.0);
    } else {
      const T E2 = 0.5 * (square(I.I1) - I.I2);
      return mu * (0.5 * I.I2 - I.I1 + 0.5 * square(E2 / I.I3) - I.I1 / I.I3 - E2 / I.I3 + 3.0);
    }
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE Partials<T> partials(const Invariants<Dim, T>& I) const {
    Partials<T> p(psi(I));
    const T r = 1.0 / I.I3, r2 = r * r;
    if constexpr (Dim == 2) {
      p.P1 = -mu * (1.0 + r);
      p.P2 = 0.5 * mu * (1.0 + r2);
      p.P3 = mu * (I.I1 * r2 - I.I2 * r * r2);
      p.P33 = mu * (3.0 * I.I2 * r2 * r2 - 2.0 * I.I1 * r * r2);
      p.P23 = -mu * r * r2;
      p.P13 = mu * r2;
    } else {
      const T E2 = 0.5 * (square(I.I1) - I.I2);
      p.P1 = mu * ((I.I1 * E2 - I.I3) * r2 - 1.0 - I.I1 * r);
      p.P2 = mu * (0.5 - 0.5 * E2 * r2 + 0.5 * r);
      p.P3 = mu * ((I.I1 * I.I3 - E2 * E2) * r * r2 + E2 * r2);
      p.P11 = mu * ((E2 + square(I.I1)) * r2 - r);
      p.P22 = mu * 0.25 * r2;
      p.P33 = mu * ((3.0 * E2 * E2 - 2.0 * I.I1 * I.I3) * r2 * r2 - 2.0 * E2 * r * r2);
      p.P12 = -0.5 * mu * I.I1 * r2;
      p.P23 = mu * (E2 * r * r2 - 0.5 * r2);
      p.P13 = mu * ((I.I3 - 2.0 * I.I1 * E2) * r * r2 + I.I1 * r2);
    }
    return p;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const PrincipalStretches<Dim, T>& s) const {
    T sum(0.0);
    for (int i = 0; i < Dim; ++i) sum = sum + square(s[i] - 1.0) * (1.0 + square(1.0 / s[i]));
    return 0.5 * mu * sum;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE void derivatives(const PrincipalStretches<Dim, T>& s,
                                     StretchDerivatives<Dim, T>& d) const {
    T r[Dim];
    T sum(0.0);
    for (int i = 0; i < Dim; ++i) {
      r[i] = 1.0 / s[i];
      const T e = s[i] - 1.0, r2 = r[i] * r[i], r3 = r2 * r[i];
      sum = sum + e * e * (1.0 + r2);
      d.gradient[i] = mu * e * (1.0 + r3);
      d.diagonal[i] = mu * (1.0 - 2.0 * r3 + 3.0 * r2 * r2);
    }
    d.psi = 0.5 * mu * sum;
    for (int i = 0; i < s.pairs; ++i) {
      const T p = r[first<Dim>(i)], q = r[second<Dim>(i)], pq = p * q;
      d.twist[i] = (d.gradient[first<Dim>(i)] + d.gradient[second<Dim>(i)]) / s.safe_sum(i);
      d.flip[i] = mu * (1.0 + (p * p + pq + q * q - p - q) * pq);
    }
    d.set_decoupled();
  }
};

}  // namespace isostretch::energies
