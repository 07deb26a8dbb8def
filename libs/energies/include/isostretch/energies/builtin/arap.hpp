#pragma once

#include <isostretch/energies/forms.hpp>

namespace isostretch::energies {

/// The as-rigid-as-possible energy: psi = |F - R|^2 = sum (sigma - 1)^2 (Smith, de Goes, Kim 2019, section
/// 5.1, where the constant must be plus dim, not plus dim^2). Finite under inversion. Only twists can be
/// negative, where sigma_j + sigma_k < 2.
struct Arap {
  static constexpr const char* name = "arap";
  static constexpr bool decoupled = true;

  template <class Visitor>
  void parameters(Visitor&&) {}

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const Invariants<Dim, T>& I) const {
    return I.I2 - 2.0 * I.I1 + double(Dim);
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE Partials<T> partials(const Invariants<Dim, T>& I) const {
    Partials<T> p(psi(I));
    p.P1 = T(-2.0);
    p.P2 = T(1.0);
    return p;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const PrincipalStretches<Dim, T>& s) const {
    T sum = square(s[0] - 1.0);
    for (int i = 1; i < Dim; ++i) sum = sum + square(s[i] - 1.0);
    return sum;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE void derivatives(const PrincipalStretches<Dim, T>& s,
                                     StretchDerivatives<Dim, T>& d) const {
    d.psi = psi(s);
    for (int i = 0; i < Dim; ++i) d.gradient[i] = 2.0 * (s[i] - 1.0), d.diagonal[i] = T(2.0);
    for (int i = 0; i < s.pairs; ++i) {
      d.twist[i] = 2.0 * ((s.a(i) - 1.0) + (s.b(i) - 1.0)) / s.safe_sum(i);
      d.flip[i] = T(2.0);
    }
    d.set_decoupled();
  }
};

}  // namespace isostretch::energies
