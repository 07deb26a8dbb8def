#pragma once

#include <isostretch/energies/forms.hpp>

namespace isostretch::energies {

/// A volume term to add to other energies that treats growing and shrinking alike: psi = weight (J + 1/J - 2)
/// / 2. Infinite at det F <= 0.
struct VolumeSymmetric {
  static constexpr const char* name = "volume_symmetric";
  static constexpr double minimum_determinant = 0.0;

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
    return 0.5 * weight * (I.I3 + 1.0 / I.I3 - 2.0);
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE Partials<T> partials(const Invariants<Dim, T>& I) const {
    Partials<T> p(psi(I));
    const T r = 1.0 / I.I3;
    p.P3 = 0.5 * weight * (1.0 - r * r);
    p.P33 = weight * r * r * r;
    return p;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const PrincipalStretches<Dim, T>& s) const {
    const T j = s.J_minus_one();
    return 0.5 * weight * j * j / s.J();
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE void derivatives(const PrincipalStretches<Dim, T>& s,
                                     StretchDerivatives<Dim, T>& d) const {
    const T J = s.J(), r = 1.0 / J, j = s.J_minus_one();
    set_zero(d);
    d.psi = 0.5 * weight * j * j * r;
    add_volumetric(s, 0.5 * weight * (j * (J + 1.0)) * (r * r), weight * r * r * r, d);
  }
};

}  // namespace isostretch::energies
