#pragma once

#include <isostretch/energies/forms.hpp>

namespace isostretch::energies {

/// The logarithmic Neo-Hookean energy (Bonet and Wood): psi = mu/2 (|F|^2 - dim) - mu log J + lambda/2
/// log(J)^2. Infinite at det F <= 0. The Lame parameters of small strain are (mu, lambda).
struct NeoHookeanLog {
  static constexpr const char* name = "neo_hookean_log";
  static constexpr double minimum_determinant = 0.0;

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
    using isostretch::log;
    const T L = log(I.I3);
    return 0.5 * mu * (I.I2 - double(Dim)) - mu * L + 0.5 * lambda * square(L);
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE Partials<T> partials(const Invariants<Dim, T>& I) const {
    Partials<T> p(psi(I));
    const T L = log(I.I3), r = 1.0 / I.I3;
    p.P2 = T(0.5 * mu);
    p.P3 = (lambda * L - mu) * r;
    p.P33 = (lambda + mu - lambda * L) * r * r;
    return p;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const PrincipalStretches<Dim, T>& s) const {
    const T L = log_determinant(s);
    return 0.5 * mu * s.I2_minus_dim() - mu * L + 0.5 * lambda * L * L;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE void derivatives(const PrincipalStretches<Dim, T>& s,
                                     StretchDerivatives<Dim, T>& d) const {
    const T L = log_determinant(s), pressure = lambda * L;
    T r[Dim];
    for (int i = 0; i < Dim; ++i) r[i] = 1.0 / s[i];
    d.psi = 0.5 * mu * s.I2_minus_dim() - mu * L + 0.5 * pressure * L;
    for (int i = 0; i < Dim; ++i) {
      d.gradient[i] = (mu * ((s[i] - 1.0) * (s[i] + 1.0)) + pressure) * r[i];
      d.diagonal[i] = mu + (lambda + mu - pressure) * r[i] * r[i];
    }
    for (int i = 0; i < s.pairs; ++i) {
      const T pq = r[first<Dim>(i)] * r[second<Dim>(i)];
      d.twist[i] = (mu * product_difference(s.a(i), s.b(i), T(1.0), T(1.0)) + pressure) * pq;
      d.flip[i] = mu - (pressure - mu) * pq;
      d.coupling[i] = lambda * pq;
    }
  }
};

}  // namespace isostretch::energies
