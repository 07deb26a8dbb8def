#pragma once

#include <isostretch/energies/forms.hpp>

namespace isostretch::energies {

/// Fixed co-rotational elasticity (Stomakhin et al. 2012): psi = mu sum (sigma - 1)^2 + lambda/2 (J - 1)^2.
/// Finite under inversion. The Lame parameters of small strain are (mu, lambda). mu = 1 is ARAP with a
/// quadratic volume term.
struct FixedCorotational {
  static constexpr const char* name = "fixed_corotational";

  double mu = 1.0;      ///< Shear modulus, in the units of psi.
  double lambda = 1.0;  ///< First Lame parameter, in the units of psi.

  template <class Visitor>
  void parameters(Visitor&& visit) {
    visit("mu", mu, "shear modulus");
    visit("lambda", lambda, "first Lame parameter");
  }

  template <class Require>
  void require_parameters(Require&& require) const {
    require("mu", mu >= 0, "must not be negative");
    require("lambda", lambda >= -2 * mu / 3, "must be at least -2/3 mu");
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const Invariants<Dim, T>& I) const {
    return mu * (I.I2 - 2.0 * I.I1 + double(Dim)) + 0.5 * lambda * square(I.I3 - 1.0);
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE Partials<T> partials(const Invariants<Dim, T>& I) const {
    Partials<T> p(psi(I));
    p.P1 = T(-2.0 * mu);
    p.P2 = T(mu);
    p.P3 = lambda * (I.I3 - 1.0);
    p.P33 = T(lambda);
    return p;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const PrincipalStretches<Dim, T>& s) const {
    T sum = square(s[0] - 1.0);
    for (int i = 1; i < Dim; ++i) sum = sum + square(s[i] - 1.0);
    return mu * sum + 0.5 * lambda * square(s.J_minus_one());
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE void derivatives(const PrincipalStretches<Dim, T>& s,
                                     StretchDerivatives<Dim, T>& d) const {
    const T j = s.J_minus_one(), pressure = lambda * j;
    d.psi = psi(s);
    for (int i = 0; i < Dim; ++i) {
      const T g = s.others(i);
      d.gradient[i] = 2.0 * mu * (s[i] - 1.0) + pressure * g;
      d.diagonal[i] = 2.0 * mu + lambda * g * g;
    }
    for (int i = 0; i < s.pairs; ++i) {
      const T c = s.c(i);
      d.twist[i] = 2.0 * mu * ((s.a(i) - 1.0) + (s.b(i) - 1.0)) / s.safe_sum(i) + c * pressure;
      d.flip[i] = 2.0 * mu - c * pressure;
      d.coupling[i] = lambda * s.others(first<Dim>(i)) * s.others(second<Dim>(i)) + c * pressure;
    }
  }
};

}  // namespace isostretch::energies
