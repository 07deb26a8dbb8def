#pragma once

#include <isostretch/energies/builtin/mips_2d.hpp>
#include <isostretch/energies/builtin/mips_3d.hpp>
#include <isostretch/energies/forms.hpp>

namespace isostretch::energies {

/// The exponential AMIPS energy (Fu, Liu, Guo 2015): psi = exp(sharpness X), X = alpha conformal + (1 -
/// alpha) (J + 1/J)/2, where the conformal term is |F|^2 / (2 J) in 2D and mips_3d in 3D. Infinite at det F
/// <= 0 and where the exponential overflows; derivatives take the exponent as at most 700.
struct ExponentialAmips {
  static constexpr const char* name = "exponential_amips";
  static constexpr double minimum_determinant = 0.0;

  double sharpness = 5.0;  ///< Factor in the exponent.
  double alpha = 0.5;      ///< Share of the conformal term, 0 to 1.

  template <class Visitor>
  void parameters(Visitor&& visit) {
    visit("sharpness", sharpness, "sharpness of the exponential");
    visit("alpha", alpha, "share of the conformal term");
  }

  template <class Require>
  void require_parameters(Require&& require) const {
    require("sharpness", sharpness > 0, "must be positive");
    require("alpha", alpha >= 0 && alpha <= 1, "must be between 0 and 1");
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const Invariants<Dim, T>& I) const {
    using isostretch::exp;
    const T volume = 0.5 * (I.I3 + 1.0 / I.I3);
    if constexpr (Dim == 2) {
      return exp(sharpness * (0.5 * alpha * (I.I2 / I.I3) + (1.0 - alpha) * volume));
    } else {
      return exp(sharpness * (alpha * Mips3d{}.psi(I) + (1.0 - alpha) * volume));
    }
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const PrincipalStretches<Dim, T>& s) const {
    StretchDerivatives<Dim, T> d;
    exponent(s, d);
    return exp(sharpness * d.psi);
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE void derivatives(const PrincipalStretches<Dim, T>& s,
                                     StretchDerivatives<Dim, T>& d) const {
    exponent(s, d);
    // Composition h(X) with h = exp(sharpness X): A gains h'' times the outer product of the gradient of X.
    const T value = exp(sharpness * d.psi);
    const T h1 = sharpness * exp(min(sharpness * d.psi, T(700.0))), h2 = sharpness * h1;
    for (int i = 0; i < s.pairs; ++i) {
      const int j = first<Dim>(i), k = second<Dim>(i);
      d.twist[i] = h1 * d.twist[i];
      d.flip[i] = h1 * d.flip[i];
      d.coupling[i] = fma(h2 * d.gradient[j], d.gradient[k], h1 * d.coupling[i]);
    }
    for (int i = 0; i < Dim; ++i) {
      d.diagonal[i] = fma(h2 * d.gradient[i], d.gradient[i], h1 * d.diagonal[i]);
      d.gradient[i] = h1 * d.gradient[i];
    }
    d.psi = value;
  }

 private:
  /// Computes X and its derivatives.
  template <int Dim, class T>
  ISOSTRETCH_INLINE void exponent(const PrincipalStretches<Dim, T>& stretch,
                                  StretchDerivatives<Dim, T>& d) const {
    if constexpr (Dim == 2) {
      Mips2d{}.derivatives(stretch, d);
      scale_derivatives(0.5 * alpha, d);
    } else {
      Mips3d{}.derivatives(stretch, d);
      scale_derivatives(alpha, d);
    }
    const T J = stretch.J(), r = 1.0 / J;
    const double beta = 1.0 - alpha;
    d.psi = d.psi + 0.5 * beta * (J + r);
    add_volumetric(stretch, 0.5 * beta * (stretch.J_minus_one() * (J + 1.0)) * (r * r), beta * r * r * r, d);
  }
};

}  // namespace isostretch::energies
