#pragma once

#include <isostretch/energies/forms.hpp>

namespace isostretch::energies {

/// The eight-chain model of Arruda and Boyce 1993, with five terms in y = |F|^2 J^(-2/dim): psi = mu sum_k
/// c_k (y^k - dim^k) / N^(k-1) + K/2 (J - 1)^2. Infinite at det F <= 0.
struct ArrudaBoyce {
  static constexpr const char* name = "arruda_boyce";
  static constexpr double minimum_determinant = 0.0;

  double mu = 1.0;  ///< Shear modulus, in the units of psi.
  double N = 10.0;  ///< Chain segments.
  double K = 1.0;   ///< Volume stiffness, in the units of psi.

  template <class Visitor>
  void parameters(Visitor&& visit) {
    visit("mu", mu, "shear modulus");
    visit("N", N, "chain segments");
    visit("K", K, "volume stiffness");
  }

  template <class Require>
  void require_parameters(Require&& require) const {
    require("mu", mu >= 0, "must not be negative");
    require("N", N > 0, "must be positive");
    require("K", K >= 0, "must not be negative");
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const Invariants<Dim, T>& I) const {
    using isostretch::pow;
    T y = I.I2 * pow(I.I3, -2.0 / Dim);
    return mu * (series(y) - series(T(double(Dim)))) + 0.5 * K * square(I.I3 - 1.0);
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const PrincipalStretches<Dim, T>& s) const {
    return mu * series_excess<Dim>(isochoric_excess(s)) + 0.5 * K * square(s.J_minus_one());
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE void derivatives(const PrincipalStretches<Dim, T>& s,
                                     StretchDerivatives<Dim, T>& d) const {
    const T y = s.I2() * isochoric_factor(s);
    const T h1 =
        mu * (c1 + y * (2.0 * c2 / N + y * (3.0 * c3 / (N * N) + y * (4.0 * c4 / (N * N * N) +
                                                                      y * (5.0 * c5 / (N * N * N * N))))));
    const T h2 =
        mu * (2.0 * c2 / N +
              y * (6.0 * c3 / (N * N) + y * (12.0 * c4 / (N * N * N) + y * (20.0 * c5 / (N * N * N * N)))));
    isochoric_derivatives(s, h1, h2, K, d);
    d.psi = psi(s);
  }

 private:
  static constexpr double c1 = 1.0 / 2, c2 = 1.0 / 20, c3 = 11.0 / 1050, c4 = 19.0 / 7000,
                          c5 = 519.0 / 673750;

  template <class T>
  ISOSTRETCH_INLINE T series(T y) const {
    return y * (c1 + y * (c2 / N + y * (c3 / (N * N) + y * (c4 / (N * N * N) + y * (c5 / (N * N * N * N))))));
  }

  /// Returns series(dim + excess) - series(dim), with y^k - dim^k = excess S_k, S_1 = 1, S_(k+1) = y S_k +
  /// dim^k.
  template <int Dim, class T>
  ISOSTRETCH_INLINE T series_excess(T excess) const {
    const double coefficients[] = {c2 / N, c3 / (N * N), c4 / (N * N * N), c5 / (N * N * N * N)};
    const T y = excess + double(Dim);
    T quotient(1.0), sum(c1);
    double power = 1;
    for (const double c : coefficients) {
      power *= Dim;
      quotient = fma(y, quotient, T(power));
      sum = fma(T(c), quotient, sum);
    }
    return excess * sum;
  }
};

}  // namespace isostretch::energies
