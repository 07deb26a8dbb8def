#pragma once

#include <isostretch/energies/forms.hpp>

namespace isostretch::energies {

/// The St. Venant-Kirchhoff energy: psi = mu |E|^2 + kappa/2 tr(E)^2, E = (F^T F - I)/2 (Smith, de Goes, Kim
/// 2019, appendix F.3, which prints |E|). Finite under inversion. Every mode can be negative. The Lame
/// parameters of small strain are (mu, kappa). mu = 4, kappa = 0 is |F^T F - I|^2.
struct StVenantKirchhoff {
  static constexpr const char* name = "st_venant_kirchhoff";

  double mu = 1.0;     ///< Shear modulus, in the units of psi.
  double kappa = 1.0;  ///< First Lame parameter, in the units of psi.

  template <class Visitor>
  void parameters(Visitor&& visit) {
    visit("mu", mu, "shear modulus");
    visit("kappa", kappa, "first Lame parameter");
  }

  template <class Require>
  void require_parameters(Require&& require) const {
    require("mu", mu >= 0, "must not be negative");
    require("kappa", kappa >= -2 * mu / 3, "must be at least -2/3 mu");
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const Invariants<Dim, T>& I) const {
    const T II_C =
        Dim == 2 ? square(I.I2) - 2.0 * square(I.I3)
                 : 0.5 * square(I.I2) - 0.5 * square(square(I.I1)) + square(I.I1) * I.I2 + 4.0 * I.I1 * I.I3;
    return 0.25 * mu * (II_C - 2.0 * I.I2 + double(Dim)) + 0.125 * kappa * square(I.I2 - double(Dim));
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE Partials<T> partials(const Invariants<Dim, T>& I) const {
    Partials<T> p(psi(I));
    if constexpr (Dim == 2) {
      p.P2 = 0.5 * mu * (I.I2 - 1.0) + 0.25 * kappa * (I.I2 - 2.0);
      p.P3 = -mu * I.I3;
      p.P22 = T(0.5 * mu + 0.25 * kappa);
      p.P33 = T(-mu);
    } else {
      p.P1 = -mu * (0.5 * I.I1 * (square(I.I1) - I.I2) - I.I3);
      p.P2 = 0.25 * mu * (I.I2 + square(I.I1) - 2.0) + 0.25 * kappa * (I.I2 - 3.0);
      p.P3 = mu * I.I1;
      p.P11 = 0.5 * mu * (I.I2 - 3.0 * square(I.I1));
      p.P22 = T(0.25 * (mu + kappa));
      p.P12 = 0.5 * mu * I.I1;
      p.P13 = T(mu);
    }
    return p;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const PrincipalStretches<Dim, T>& s) const {
    T sum(0.0);
    for (int i = 0; i < Dim; ++i) sum = sum + square(0.5 * (s[i] - 1.0) * (s[i] + 1.0));
    return mu * sum + 0.125 * kappa * square(s.I2_minus_dim());
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE void derivatives(const PrincipalStretches<Dim, T>& s,
                                     StretchDerivatives<Dim, T>& d) const {
    const T pressure = 0.5 * kappa * s.I2_minus_dim();
    d.psi = psi(s);
    for (int i = 0; i < Dim; ++i) {
      d.gradient[i] = (mu * ((s[i] - 1.0) * (s[i] + 1.0)) + pressure) * s[i];
      d.diagonal[i] = (3.0 * mu + kappa) * s[i] * s[i] + pressure - mu;
    }
    for (int i = 0; i < s.pairs; ++i) {
      const T a = s.a(i), b = s.b(i);
      d.twist[i] = pressure + mu * (product_difference(a, b, T(1.0), T(1.0)) + square(a - b));
      d.flip[i] = pressure - mu + mu * (a * a + a * b + b * b);
      d.coupling[i] = kappa * a * b;
    }
  }
};

}  // namespace isostretch::energies
