#pragma once

#include <isostretch/energies/forms.hpp>

namespace isostretch::energies {

/// The energy of most isometric parameterizations (Hormann and Greiner 2000): psi = |F|^2 / det F = a/b +
/// b/a, minimum 2 at every similarity. Smith, de Goes, Kim 2019, Eq. 37, prints the scaling eigenpairs with
/// two errors. Infinite at det F <= 0. Exists in 2D. The twist is never positive, and neither is one scaling
/// eigenvalue, since the energy is scale-invariant.
struct Mips2d {
  static constexpr const char* name = "mips_2d";
  static constexpr double minimum_determinant = 0.0;
  static constexpr bool supports(int dim) { return dim == 2; }

  template <class Visitor>
  void parameters(Visitor&&) {}

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const Invariants<Dim, T>& I) const {
    return I.I2 / I.I3;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE Partials<T> partials(const Invariants<Dim, T>& I) const {
    Partials<T> p(psi(I));
    const T r = 1.0 / I.I3;
    p.P2 = r;
    p.P3 = -I.I2 * r * r;
    p.P33 = 2.0 * I.I2 * r * r * r;
    p.P23 = -r * r;
    return p;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const PrincipalStretches<Dim, T>& s) const {
    return s[0] / s[1] + s[1] / s[0];
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE void derivatives(const PrincipalStretches<Dim, T>& s,
                                     StretchDerivatives<Dim, T>& d) const {
    const T x = s[0], y = s[1], p = 1.0 / x, q = 1.0 / y;
    const T gap = (x - y) * p * q, sum = (x + y) * p * q;
    d.psi = x * q + y * p;
    d.gradient[0] = gap * sum * y;
    d.gradient[1] = -(gap * sum * x);
    d.twist[0] = -(gap * gap);
    d.flip[0] = sum * sum;
    d.diagonal[0] = 2.0 * y * p * p * p;
    d.diagonal[1] = 2.0 * x * q * q * q;
    d.coupling[0] = -fma(p, p, q * q);
  }
};

}  // namespace isostretch::energies
