#pragma once

#include <isostretch/energies/forms.hpp>

namespace isostretch::energies {

/// Co-rotational linear elasticity: psi = mu |F - R|^2 + kappa/2 tr(S - I)^2 (Smith, de Goes, Kim 2019,
/// appendix F.1, whose twist eigenvalue lacks parentheses). Finite under inversion. The Lame parameters of
/// small strain are (mu, kappa).
struct Corotational {
  static constexpr const char* name = "corotational";

  double mu = 1.0;     ///< Shear modulus, in the units of psi.
  double kappa = 1.0;  ///< Resistance to a change of tr S, in the units of psi.

  template <class Visitor>
  void parameters(Visitor&& visit) {
    visit("mu", mu, "shear modulus");
    visit("kappa", kappa, "resistance to change of trace");
  }

  template <class Require>
  void require_parameters(Require&& require) const {
    require("mu", mu >= 0, "must not be negative");
    require("kappa", kappa >= -2 * mu / 3, "must be at least -2/3 mu");
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const Invariants<Dim, T>& I) const {
    return mu * (I.I2 - 2.0 * I.I1 + double(Dim)) + 0.5 * kappa * square(I.I1 - double(Dim));
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE Partials<T> partials(const Invariants<Dim, T>& I) const {
    Partials<T> p(psi(I));
    p.P1 = kappa * (I.I1 - double(Dim)) - 2.0 * mu;
    p.P2 = T(mu);
    p.P11 = T(kappa);
    return p;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const PrincipalStretches<Dim, T>& s) const {
    T sum = square(s[0] - 1.0);
    for (int i = 1; i < Dim; ++i) sum = sum + square(s[i] - 1.0);
    return mu * sum + 0.5 * kappa * square(s.I1_minus_dim());
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE void derivatives(const PrincipalStretches<Dim, T>& s,
                                     StretchDerivatives<Dim, T>& d) const {
    const T trace = s.I1_minus_dim();
    d.psi = psi(s);
    for (int i = 0; i < Dim; ++i) {
      d.gradient[i] = 2.0 * mu * (s[i] - 1.0) + kappa * trace;
      d.diagonal[i] = T(2.0 * mu + kappa);
    }
    for (int i = 0; i < s.pairs; ++i) {
      d.twist[i] = 2.0 * (mu * ((s.a(i) - 1.0) + (s.b(i) - 1.0)) + kappa * trace) / s.safe_sum(i);
      d.flip[i] = T(2.0 * mu);
      d.coupling[i] = T(kappa);
    }
  }
};

}  // namespace isostretch::energies
