#pragma once

#include <isostretch/energies/forms.hpp>

namespace isostretch::energies {

/// Stable Neo-Hookean elasticity without a logarithm: psi = mu/2 (|F|^2 - dim) - mu (J - 1) + lambda/2 (J -
/// 1)^2. Finite under inversion. The Lame parameters of small strain are (mu, lambda - mu); pass lambda =
/// lambda_Lame + mu.
struct StableNeoHookean {
  static constexpr const char* name = "stable_neo_hookean";

  double mu = 1.0;      ///< Shear modulus, in the units of psi.
  double lambda = 1.0;  ///< Volume stiffness, lambda_Lame + mu, in the units of psi.

  template <class Visitor>
  void parameters(Visitor&& visit) {
    visit("mu", mu, "shear modulus");
    visit("lambda", lambda, "volume stiffness, Lame lambda + mu");
  }

  template <class Require>
  void require_parameters(Require&& require) const {
    require("mu", mu >= 0, "must not be negative");
    require("lambda", lambda >= 0, "must not be negative");
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const Invariants<Dim, T>& I) const {
    return 0.5 * mu * (I.I2 - double(Dim)) - mu * (I.I3 - 1.0) + 0.5 * lambda * square(I.I3 - 1.0);
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE Partials<T> partials(const Invariants<Dim, T>& I) const {
    Partials<T> p(psi(I));
    p.P2 = T(0.5 * mu);
    p.P3 = lambda * (I.I3 - 1.0) - mu;
    p.P33 = T(lambda);
    return p;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const PrincipalStretches<Dim, T>& s) const {
    const T j = s.J_minus_one();
    return 0.5 * mu * s.I2_minus_dim() - mu * j + 0.5 * lambda * j * j;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE void derivatives(const PrincipalStretches<Dim, T>& s,
                                     StretchDerivatives<Dim, T>& d) const {
    const T j = s.J_minus_one(), pressure = lambda * j;
    d.psi = 0.5 * mu * s.I2_minus_dim() - mu * j + 0.5 * pressure * j;
    for (int i = 0; i < Dim; ++i) {
      const T g = s.others(i);
      d.gradient[i] = mu * s.minus_others(i) + pressure * g;
      d.diagonal[i] = mu + lambda * g * g;
    }
    for (int i = 0; i < s.pairs; ++i) {
      const T c = s.c(i);
      d.twist[i] = mu * (1.0 - c) + c * pressure;
      d.flip[i] = mu - c * (pressure - mu);
      d.coupling[i] = lambda * s.others(first<Dim>(i)) * s.others(second<Dim>(i)) + c * (pressure - mu);
    }
  }
};

}  // namespace isostretch::energies
