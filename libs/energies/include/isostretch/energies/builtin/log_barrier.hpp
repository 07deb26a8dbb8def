#pragma once

#include <isostretch/energies/forms.hpp>

namespace isostretch::energies {

/// A logarithmic barrier to add to other energies: psi = -weight log J. Infinite at det F <= 0.
struct LogBarrier {
  static constexpr const char* name = "log_barrier";
  static constexpr double minimum_determinant = 0.0;
  static constexpr bool decoupled = true;

  double weight = 1.0;  ///< Stiffness, in the units of psi.

  template <class Visitor>
  void parameters(Visitor&& visit) {
    visit("weight", weight, "stiffness");
  }

  template <class Require>
  void require_parameters(Require&& require) const {
    require("weight", weight >= 0, "must not be negative");
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const Invariants<Dim, T>& I) const {
    using isostretch::log;
    return -weight * log(I.I3);
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE Partials<T> partials(const Invariants<Dim, T>& I) const {
    Partials<T> p(psi(I));
    const T r = 1.0 / I.I3;
    p.P3 = -weight * r;
    p.P33 = weight * r * r;
    return p;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const PrincipalStretches<Dim, T>& s) const {
    return -weight * log_determinant(s);
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE void derivatives(const PrincipalStretches<Dim, T>& s,
                                     StretchDerivatives<Dim, T>& d) const {
    T r[Dim];
    for (int i = 0; i < Dim; ++i) {
      r[i] = 1.0 / s[i];
      d.gradient[i] = -weight * r[i];
      d.diagonal[i] = weight * r[i] * r[i];
    }
    d.psi = psi(s);
    for (int i = 0; i < s.pairs; ++i) {
      d.flip[i] = weight * r[first<Dim>(i)] * r[second<Dim>(i)];
      d.twist[i] = -d.flip[i];
    }
    d.set_decoupled();
  }
};

}  // namespace isostretch::energies
