#pragma once

#include <isostretch/energies/forms.hpp>

namespace isostretch::energies {

/// The Dirichlet energy: psi = 1/2 |F|^2. Convex; the state of least energy is a point.
struct Dirichlet {
  static constexpr const char* name = "dirichlet";
  static constexpr bool decoupled = true;

  template <class Visitor>
  void parameters(Visitor&&) {}

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const Invariants<Dim, T>& I) const {
    return 0.5 * I.I2;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE Partials<T> partials(const Invariants<Dim, T>& I) const {
    Partials<T> p(psi(I));
    p.P2 = T(0.5);
    return p;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const PrincipalStretches<Dim, T>& s) const {
    return 0.5 * s.I2();
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE void derivatives(const PrincipalStretches<Dim, T>& s,
                                     StretchDerivatives<Dim, T>& d) const {
    d.psi = psi(s);
    for (int i = 0; i < Dim; ++i) d.gradient[i] = s[i], d.diagonal[i] = T(1.0);
    for (int i = 0; i < s.pairs; ++i) d.twist[i] = d.flip[i] = T(1.0);
    d.set_decoupled();
  }
};

}  // namespace isostretch::energies
