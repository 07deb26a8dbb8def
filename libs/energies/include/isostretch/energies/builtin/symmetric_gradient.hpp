#pragma once

#include <isostretch/energies/forms.hpp>

namespace isostretch::energies {

/// The symmetric gradient energy: psi = 1/2 |F|^2 - log J (Stein, Li, Solomon 2022 and others), which is
/// neo_hookean_log with mu = 1, lambda = 0 up to a constant. Infinite at det F <= 0. Only twists can be
/// negative, where a b < 1.
struct SymmetricGradient {
  static constexpr const char* name = "symmetric_gradient";
  static constexpr double minimum_determinant = 0.0;
  static constexpr bool decoupled = true;

  template <class Visitor>
  void parameters(Visitor&&) {}

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const Invariants<Dim, T>& I) const {
    using isostretch::log;
    return 0.5 * I.I2 - log(I.I3);
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE Partials<T> partials(const Invariants<Dim, T>& I) const {
    Partials<T> p(psi(I));
    const T r = 1.0 / I.I3;
    p.P2 = T(0.5);
    p.P3 = -r;
    p.P33 = r * r;
    return p;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const PrincipalStretches<Dim, T>& s) const {
    return 0.5 * s.I2() - log_determinant(s);
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE void derivatives(const PrincipalStretches<Dim, T>& s,
                                     StretchDerivatives<Dim, T>& d) const {
    T r[Dim];
    for (int i = 0; i < Dim; ++i) {
      r[i] = 1.0 / s[i];
      d.gradient[i] = (s[i] - 1.0) * (s[i] + 1.0) * r[i];
      d.diagonal[i] = fma(r[i], r[i], T(1.0));
    }
    d.psi = psi(s);
    for (int i = 0; i < s.pairs; ++i) {
      const T pq = r[first<Dim>(i)] * r[second<Dim>(i)];
      d.twist[i] = product_difference(s.a(i), s.b(i), T(1.0), T(1.0)) * pq;
      d.flip[i] = 1.0 + pq;
    }
    d.set_decoupled();
  }
};

}  // namespace isostretch::energies
