#pragma once

#include <isostretch/energies/forms.hpp>

namespace isostretch::energies {

/// The conformal AMIPS energy (Fu, Liu, Guo 2015, in its scale-invariant form): psi = |F|^2 / (3 det
/// F^(2/3)), minimum 1 at every similarity. Infinite at det F <= 0. Exists in 3D.
struct ConformalAmips3d {
  static constexpr const char* name = "conformal_amips_3d";
  static constexpr double minimum_determinant = 0.0;
  static constexpr bool supports(int dim) { return dim == 3; }

  template <class Visitor>
  void parameters(Visitor&&) {}

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const Invariants<Dim, T>& I) const {
    using isostretch::cbrt;
    return I.I2 / (3.0 * square(cbrt(I.I3)));
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE Partials<T> partials(const Invariants<Dim, T>& I) const {
    Partials<T> p(psi(I));
    const T r = 1.0 / I.I3, c = cbrt(r), w = c * c / 3.0;
    p.P2 = w;
    p.P3 = -2.0 / 3.0 * w * I.I2 * r;
    p.P33 = 10.0 / 9.0 * w * I.I2 * r * r;
    p.P23 = -2.0 / 3.0 * w * r;
    return p;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const PrincipalStretches<Dim, T>& s) const {
    return s.I2() / (3.0 * square(cbrt(s.J())));
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE void derivatives(const PrincipalStretches<Dim, T>& s,
                                     StretchDerivatives<Dim, T>& d) const {
    const T I2 = s.I2(), c = cbrt(1.0 / s.J()), w = c * c / 3.0;
    d.psi = w * I2;
    for (int i = 0; i < 3; ++i) {
      const T r = 1.0 / s[i];
      const T j = s[(i + 1) % 3], k = s[(i + 2) % 3];
      d.gradient[i] = 2.0 / 3.0 * w * ((s[i] - j) * (s[i] + j) + (s[i] - k) * (s[i] + k)) * r;
      d.diagonal[i] = w * (10.0 / 9.0 * I2 * r * r - 2.0 / 3.0);
    }
    for (int i = 0; i < 3; ++i) {
      const T a = s.a(i), b = s.b(i), z = s.c(i), r = 1.0 / (a * b);
      d.twist[i] = 2.0 / 3.0 * w * (product_difference(a, b, z, z) - square(a - b)) * r;
      d.flip[i] = w * (2.0 + 2.0 / 3.0 * I2 * r);
      d.coupling[i] = 2.0 / 3.0 * w * (2.0 / 3.0 * I2 - 2.0 * (a * a + b * b)) * r;
    }
  }
};

}  // namespace isostretch::energies
