#pragma once

#include <isostretch/energies/forms.hpp>

namespace isostretch::energies {

/// The MIPS energy in 3D, the conformal term of AMIPS (Fu, Liu, Guo 2015): psi = (|F|^2 |F^-1|^2 - 1) / 8 =
/// prod (a/b + b/a) / 8, minimum 1 at every similarity. Infinite at det F <= 0. Exists in 3D.
struct Mips3d {
  static constexpr const char* name = "mips_3d";
  static constexpr double minimum_determinant = 0.0;
  static constexpr bool supports(int dim) { return dim == 3; }

  template <class Visitor>
  void parameters(Visitor&&) {}

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const Invariants<Dim, T>& I) const {
    const T E2 = 0.5 * (square(I.I1) - I.I2);
    const T N = (square(E2) - 2.0 * I.I1 * I.I3) / square(I.I3);
    return (I.I2 * N - 1.0) / 8.0;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE Partials<T> partials(const Invariants<Dim, T>& I) const {
    Partials<T> p(psi(I));
    const T r = 1.0 / I.I3, r2 = r * r, E2 = 0.5 * (square(I.I1) - I.I2);
    const T N = (square(E2) - 2.0 * I.I1 * I.I3) * r2;
    const T K = I.I1 * E2 - I.I3;
    p.P1 = 0.25 * I.I2 * K * r2;
    p.P2 = 0.125 * (N - I.I2 * E2 * r2);
    p.P3 = 0.25 * I.I2 * (I.I1 * I.I3 - E2 * E2) * r * r2;
    p.P11 = 0.25 * I.I2 * (E2 + square(I.I1)) * r2;
    p.P22 = 0.125 * (0.5 * I.I2 * r2 - 2.0 * E2 * r2);
    p.P33 = 0.125 * I.I2 * (6.0 * E2 * E2 - 4.0 * I.I1 * I.I3) * r2 * r2;
    p.P12 = 0.125 * (2.0 * K - I.I1 * I.I2) * r2;
    p.P23 = 0.25 * ((I.I1 * I.I3 - E2 * E2) * r * r2 + I.I2 * E2 * r * r2);
    p.P13 = 0.25 * I.I2 * (I.I3 - 2.0 * I.I1 * E2) * r * r2;
    return p;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const PrincipalStretches<Dim, T>& s) const {
    T N(0.0);
    for (int i = 0; i < 3; ++i) N = N + square(1.0 / s[i]);
    return (s.I2() * N - 1.0) / 8.0;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE void derivatives(const PrincipalStretches<Dim, T>& s,
                                     StretchDerivatives<Dim, T>& d) const {
    T r[3];
    T N(0.0);
    for (int i = 0; i < 3; ++i) r[i] = 1.0 / s[i], N = N + r[i] * r[i];
    const T I2 = s.I2();
    d.psi = (I2 * N - 1.0) / 8.0;
    for (int i = 0; i < 3; ++i) {
      const T r2 = r[i] * r[i];
      T sum(0.0);
      for (int step = 1; step <= 2; ++step) {
        const T y = s[(i + step) % 3], q = r[(i + step) % 3];
        sum = sum + (s[i] - y) * (s[i] + y) * ((s[i] * s[i] + y * y) * (q * q));
      }
      d.gradient[i] = 0.25 * sum * r2 * r[i];
      d.diagonal[i] = 0.25 * (N + 3.0 * I2 * r2 * r2 - 4.0 * r2);
    }
    for (int i = 0; i < 3; ++i) {
      const int j = first<3>(i), k = second<3>(i);
      const T a = s[j], b = s[k], z = s[i], p = r[j], q = r[k], pq = p * q;
      const T gap = (a - b) * (a - b) * pq;
      // twist: differences of products in place of 1/sigma^2 terms that cancel at rest.
      d.twist[i] = 0.25 * (product_difference(a, b, z, z) * (a * b + z * z) * square(r[i] * pq) -
                           gap * (square(z * pq) + (2.0 + gap) * pq));
      d.flip[i] = 0.25 * (N + I2 * (p * p + pq + q * q) * pq);
      d.coupling[i] = -0.5 * (a * q * q * q + b * p * p * p);
    }
  }
};

}  // namespace isostretch::energies
