#pragma once

#include <isostretch/energies/forms.hpp>

namespace isostretch::energies {

/// The Mooney-Rivlin energy: psi = c10 (J^(-2/3) |F|^2 - 3) + c01 (J^(-4/3) |cof F|^2 - 3) + K/2 (J - 1)^2.
/// Infinite at det F <= 0. Exists in 3D.
struct MooneyRivlin3d {
  static constexpr const char* name = "mooney_rivlin_3d";
  static constexpr double minimum_determinant = 0.0;
  static constexpr bool supports(int dim) { return dim == 3; }

  double c10 = 0.5;  ///< First Mooney-Rivlin coefficient, in the units of psi.
  double c01 = 0.1;  ///< Second Mooney-Rivlin coefficient, in the units of psi.
  double K = 1.0;    ///< Volume stiffness, in the units of psi.

  template <class Visitor>
  void parameters(Visitor&& visit) {
    visit("c10", c10, "first Mooney-Rivlin coefficient");
    visit("c01", c01, "second Mooney-Rivlin coefficient");
    visit("K", K, "volume stiffness");
  }

  template <class Require>
  void require_parameters(Require&& require) const {
    require("c10", c10 + c01 >= 0, "plus c01 must not be negative");
    require("K", K >= 0, "must not be negative");
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const Invariants<Dim, T>& I) const {
    using isostretch::cbrt;
    const T M = 0.25 * square(square(I.I1) - I.I2) - 2.0 * I.I1 * I.I3;
    const T v = 1.0 / square(cbrt(I.I3));
    return c10 * (v * I.I2 - 3.0) + c01 * (square(v) * M - 3.0) + 0.5 * K * square(I.I3 - 1.0);
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE Partials<T> partials(const Invariants<Dim, T>& I) const {
    Partials<T> p(psi(I));
    const T E = square(I.I1) - I.I2, M = 0.25 * square(E) - 2.0 * I.I1 * I.I3, r = 1.0 / I.I3;
    const T v = square(cbrt(r)), v2 = v * v, Q = 0.5 * I.I1 * E - I.I3;
    p.P1 = 2.0 * c01 * v2 * Q;
    p.P2 = c10 * v - 0.5 * c01 * v2 * E;
    p.P3 = -2.0 / 3.0 * c10 * v * I.I2 * r - c01 * v2 * (2.0 * I.I1 + 4.0 / 3.0 * M * r) + K * (I.I3 - 1.0);
    p.P11 = c01 * v2 * (3.0 * square(I.I1) - I.I2);
    p.P22 = 0.5 * c01 * v2;
    p.P33 = 10.0 / 9.0 * c10 * v * I.I2 * r * r + c01 * v2 * r * (28.0 / 9.0 * M * r + 16.0 / 3.0 * I.I1) + K;
    p.P12 = -c01 * v2 * I.I1;
    p.P23 = (2.0 / 3.0 * c01 * v2 * E - 2.0 / 3.0 * c10 * v) * r;
    p.P13 = -c01 * v2 * (2.0 + 8.0 / 3.0 * Q * r);
    return p;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const PrincipalStretches<Dim, T>& s) const {
    const CubeRoots<T> roots(s);
    return c10 * roots.excess() + c01 * roots.cofactor_excess() + 0.5 * K * square(s.J_minus_one());
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE void derivatives(const PrincipalStretches<Dim, T>& s,
                                     StretchDerivatives<Dim, T>& d) const {
    const T v = isochoric_factor(s), v2 = c01 * v * v, w = c10 * v, I2 = s.I2(), M = cofactor_norm(s);
    T r[3], m[3];
    for (int i = 0; i < 3; ++i) {
      r[i] = 1.0 / s[i];
      const T j = s[(i + 1) % 3], k = s[(i + 2) % 3];
      m[i] = j * j + k * k;  // I2 - sigma_i^2
      // Differences of squares: both isochoric terms vanish at rest without cancellation.
      const T spread = (s[i] - j) * (s[i] + j) + (s[i] - k) * (s[i] + k);
      const T cofactor_spread = k * k * (s[i] - j) * (s[i] + j) + j * j * (s[i] - k) * (s[i] + k);
      d.gradient[i] = (2.0 / 3.0) * (w * spread + v2 * cofactor_spread) * r[i];
      const T r2 = r[i] * r[i];
      d.diagonal[i] =
          w * (10.0 / 9.0 * I2 * r2 - 2.0 / 3.0) + v2 * ((2.0 - 16.0 / 3.0) * m[i] + 28.0 / 9.0 * M * r2);
    }
    for (int i = 0; i < 3; ++i) {
      const T a = s.a(i), b = s.b(i), z = s.c(i), pq = r[first<3>(i)] * r[second<3>(i)], u = a * b;
      const T gap = product_difference(a, b, z, z), spread = square(a - b) * pq;
      d.twist[i] = (2.0 / 3.0) * (w * (gap * pq - spread) + v2 * (gap - 2.0 * z * z * spread));
      d.flip[i] = w * (2.0 + 2.0 / 3.0 * I2 * pq) + v2 * (2.0 * (z * z - u) + 4.0 / 3.0 * M * pq);
      const T ma = 2.0 * a * m[first<3>(i)], mb = 2.0 * b * m[second<3>(i)];
      d.coupling[i] =
          w * (2.0 / 3.0) * (2.0 / 3.0 * I2 - 2.0 * (a * a + b * b)) * pq +
          v2 * (4.0 * u - 4.0 / 3.0 * (ma * r[second<3>(i)] + mb * r[first<3>(i)]) + 16.0 / 9.0 * M * pq);
    }
    add_volumetric(s, K * s.J_minus_one(), T(K), d);
    d.psi = psi(s);
  }

 private:
  /// Returns |cof F|^2.
  template <class T>
  ISOSTRETCH_INLINE static T cofactor_norm(const PrincipalStretches<3, T>& s) {
    return square(s[0] * s[1]) + square(s[1] * s[2]) + square(s[2] * s[0]);
  }
};

}  // namespace isostretch::energies
