#pragma once

#include <isostretch/energies/forms.hpp>

namespace isostretch::energies {

/// The exponential soft-tissue model of Fung and Demiray in y = |F|^2 J^(-2/dim): psi = mu/(2 b) (exp(b (y -
/// dim)) - 1) + K/2 (J - 1)^2. Infinite at det F <= 0 and where the exponential overflows.
struct Fung {
  static constexpr const char* name = "fung";
  static constexpr double minimum_determinant = 0.0;

  double mu = 1.0;  ///< Shear modulus, in the units of psi.
  double b = 1.0;   ///< Stiffening, the factor in the exponent.
  double K = 1.0;   ///< Volume stiffness, in the units of psi.

  template <class Visitor>
  void parameters(Visitor&& visit) {
    visit("mu", mu, "shear modulus");
    visit("b", b, "stiffening");
    visit("K", K, "volume stiffness");
  }

  template <class Require>
  void require_parameters(Require&& require) const {
    require("mu", mu >= 0, "must not be negative");
    require("b", b > 0, "must be positive");
    require("K", K >= 0, "must not be negative");
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const Invariants<Dim, T>& I) const {
    using isostretch::expm1;
    using isostretch::pow;
    const T y = I.I2 * pow(I.I3, -2.0 / Dim);
    return 0.5 * mu / b * expm1(b * (y - double(Dim))) + 0.5 * K * square(I.I3 - 1.0);
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const PrincipalStretches<Dim, T>& s) const {
    return 0.5 * mu / b * expm1(b * isochoric_excess(s)) + 0.5 * K * square(s.J_minus_one());
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE void derivatives(const PrincipalStretches<Dim, T>& s,
                                     StretchDerivatives<Dim, T>& d) const {
    const T h1 = 0.5 * mu * exp(min(b * isochoric_excess(s), T(700.0)));
    isochoric_derivatives(s, h1, b * h1, K, d);
    d.psi = psi(s);
  }
};

}  // namespace isostretch::energies
