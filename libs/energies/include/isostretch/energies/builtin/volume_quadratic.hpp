#pragma once

#include <isostretch/energies/forms.hpp>

namespace isostretch::energies {

/// A quadratic volume term to add to other energies: psi = weight (J - 1)^2. Finite under inversion.
struct VolumeQuadratic {
  static constexpr const char* name = "volume_quadratic";

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
    return weight * square(I.I3 - 1.0);
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE Partials<T> partials(const Invariants<Dim, T>& I) const {
    Partials<T> p(psi(I));
    p.P3 = 2.0 * weight * (I.I3 - 1.0);
    p.P33 = T(2.0 * weight);
    return p;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const PrincipalStretches<Dim, T>& s) const {
    return weight * square(s.J_minus_one());
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE void derivatives(const PrincipalStretches<Dim, T>& s,
                                     StretchDerivatives<Dim, T>& d) const {
    const T j = s.J_minus_one();
    set_zero(d);
    d.psi = weight * j * j;
    add_volumetric(s, 2.0 * weight * j, T(2.0 * weight), d);
  }
};

}  // namespace isostretch::energies
