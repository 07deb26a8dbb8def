#pragma once

#include <isostretch/energies/forms.hpp>

namespace isostretch::energies {

/// Stable Neo-Hookean elasticity of Smith, de Goes, Kim 2018: psi = mu/2 (|F|^2 - dim) + lambda/2 (J -
/// alpha)^2 - mu/2 log(|F|^2 + 1), alpha = 1 + mu/lambda dim/(dim + 1). Stress-free at rest, where psi is not
/// zero. Finite under inversion. In 3D, small strain has mu_Lame = 3/4 mu, lambda_Lame = lambda - 5/8 mu.
struct StableNeoHookeanLog {
  static constexpr const char* name = "stable_neo_hookean_log";

  double mu = 1.0;      ///< Shear parameter, 4/3 of the Lame modulus in 3D, in the units of psi.
  double lambda = 1.0;  ///< Volume stiffness, in the units of psi.

  template <class Visitor>
  void parameters(Visitor&& visit) {
    visit("mu", mu, "shear parameter, 4/3 of the Lame modulus in 3D");
    visit("lambda", lambda, "volume stiffness");
  }

  template <class Require>
  void require_parameters(Require&& require) const {
    require("mu", mu >= 0, "must not be negative");
    require("lambda", lambda > 0, "must be positive");
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const Invariants<Dim, T>& I) const {
    using isostretch::log;
    return 0.5 * mu * (I.I2 - double(Dim)) + 0.5 * lambda * square(I.I3 - alpha<Dim>()) -
           0.5 * mu * log(I.I2 + 1.0);
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE Partials<T> partials(const Invariants<Dim, T>& I) const {
    Partials<T> p(psi(I));
    const T r = 1.0 / (I.I2 + 1.0);
    p.P2 = 0.5 * mu * I.I2 * r;
    p.P3 = lambda * (I.I3 - alpha<Dim>());
    p.P22 = 0.5 * mu * r * r;
    p.P33 = T(lambda);
    return p;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const PrincipalStretches<Dim, T>& s) const {
    return 0.5 * mu * s.I2_minus_dim() + 0.5 * lambda * square(s.J() - alpha<Dim>()) -
           0.5 * mu * log(s.I2() + 1.0);
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE void derivatives(const PrincipalStretches<Dim, T>& s,
                                     StretchDerivatives<Dim, T>& d) const {
    // The rest values dim/(dim + 1) are taken out of both terms, so that they do not cancel there; towards
    // F = 0 it is the other way round.
    constexpr double rest = double(Dim) / (Dim + 1);
    const T I2 = s.I2(), r = 1.0 / (I2 + 1.0);
    const T shear = mu * I2 * r, excess = mu * s.I2_minus_dim() * r * (1.0 / (Dim + 1));
    const T stress = lambda * s.J_minus_one(), pressure = stress - mu * rest;
    const auto small = I2 < T(0.5);
    d.psi = psi(s);
    for (int i = 0; i < Dim; ++i) {
      const T g = s.others(i);
      d.gradient[i] = select(small, shear * s[i] + pressure * g,
                             stress * g + excess * s[i] + mu * rest * s.minus_others(i));
      d.diagonal[i] = shear + 2.0 * mu * square(s[i] * r) + lambda * g * g;
    }
    for (int i = 0; i < s.pairs; ++i) {
      const T c = s.c(i);
      const int j = first<Dim>(i), k = second<Dim>(i);
      d.twist[i] = select(small, shear + c * pressure, excess + mu * rest * (1.0 - c) + c * stress);
      d.flip[i] = shear - c * pressure;
      d.coupling[i] = 2.0 * mu * (s[j] * r) * (s[k] * r) + lambda * s.others(j) * s.others(k) + c * pressure;
    }
  }

  /// Returns the determinant alpha = 1 + mu/lambda dim/(dim + 1), with which the rest state is free of
  /// stress.
  template <int Dim>
  double alpha() const {
    return 1.0 + mu / lambda * Dim / (Dim + 1);
  }
};

}  // namespace isostretch::energies
