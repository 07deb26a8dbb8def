#pragma once

// From psi(I1, I2, I3) to everything else: the generic path that every isotropic energy can take.
//
//   twist_i = 2 P1 / (sigma_j + sigma_k) + 2 P2 + sigma_i P3,    flip_i = 2 P2 - sigma_i P3,    A as below
//
// (Smith, de Goes, Kim 2019, Eqs. 22, 23 and section 5.3; products of the other sigmas in place of their I3 /
// sigma_i, which is 0/0 at sigma_i = 0). Exact algebra, but not exact arithmetic: where some sigma is small,
// energies with inverse powers lose digits of the 3D twist in the cancelling partials. Built-in energies use
// forms in sigma instead.

#include <isostretch/invariants/jet.hpp>
#include <isostretch/invariants/stretch.hpp>

namespace isostretch::invariants {
inline namespace ISOSTRETCH_ISA {

/// An energy density and its partial derivatives with respect to the invariants: P1 = d psi / d I1, P12 = d2
/// psi / d I1 d I2, ...
template <class T>
struct Partials {
  T psi{};  ///< The energy density.
  T P1{};   ///< d psi / d I1.
  T P2{};   ///< d psi / d I2.
  T P3{};   ///< d psi / d I3.
  T P11{};  ///< d2 psi / d I1 d I1.
  T P22{};  ///< d2 psi / d I2 d I2.
  T P33{};  ///< d2 psi / d I3 d I3.
  T P12{};  ///< d2 psi / d I1 d I2.
  T P23{};  ///< d2 psi / d I2 d I3.
  T P13{};  ///< d2 psi / d I1 d I3.

  Partials() = default;
  /// Makes a constant: all derivatives are zero until a closed form sets them.
  ISOSTRETCH_INLINE explicit Partials(T value)
      : psi(value), P1(0.0), P2(0.0), P3(0.0), P11(0.0), P22(0.0), P33(0.0), P12(0.0), P23(0.0), P13(0.0) {}
};

/// Returns psi(I1, I2, I3) of an energy with all its partial derivatives, by second-order jets.
template <int Dim, class T, class Energy>
ISOSTRETCH_INLINE Partials<T> partials_by_jets(const Energy& energy, const Invariants<Dim, T>& I) {
  const Jet2<T> psi = energy.psi(Invariants<Dim, Jet2<T>>{{I.I1, 1}, {I.I2, 2}, {I.I3, 3}});
  Partials<T> p(psi.v);
  p.P1 = psi.d1, p.P2 = psi.d2, p.P3 = psi.d3;
  p.P11 = psi.d11, p.P22 = psi.d22, p.P33 = psi.d33;
  p.P12 = psi.d12, p.P23 = psi.d23, p.P13 = psi.d13;
  return p;
}

/// Computes the derivatives over the stretch from those over the invariants: twist_i = 2 P1 / (sigma_j +
/// sigma_k) + 2 P2 + sigma_i P3, flip_i = 2 P2 - sigma_i P3 (Smith, de Goes, Kim 2019, Eqs. 22, 23 and
/// section 5.3).
template <int Dim, class T>
ISOSTRETCH_INLINE void derivatives_from_partials(const PrincipalStretches<Dim, T>& s, const Partials<T>& p,
                                                 StretchDerivatives<Dim, T>& d) {
  const T two(2.0), four(4.0);
  d.psi = p.psi;
  const T J = s.J();
  for (int i = 0; i < Dim; ++i) {
    const T g = s.others(i);
    d.gradient[i] = p.P1 + two * s[i] * p.P2 + g * p.P3;
    d.diagonal[i] = two * p.P2 + p.P11 + four * s[i] * s[i] * p.P22 + g * g * p.P33 + four * s[i] * p.P12 +
                    four * J * p.P23 + two * g * p.P13;
  }
  for (int i = 0; i < pair_count<Dim>; ++i) {
    const int j = first<Dim>(i), k = second<Dim>(i);
    const T gj = s.others(j), gk = s.others(k);
    d.twist[i] = two * p.P1 / s.safe_sum(i) + two * p.P2 + s.c(i) * p.P3;
    d.flip[i] = two * p.P2 - s.c(i) * p.P3;
    d.coupling[i] = s.c(i) * p.P3 + p.P11 + four * s[j] * s[k] * p.P22 + gj * gk * p.P33 +
                    two * (s[j] + s[k]) * p.P12 + two * (s[j] * gk + s[k] * gj) * p.P23 + (gj + gk) * p.P13;
  }
}

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch::invariants
