#pragma once

#include <isostretch/energies/forms.hpp>

namespace isostretch::energies {

/// The Hencky energy: psi = mu sum log(sigma)^2 + lambda/2 log(J)^2. It has no algebraic form in the
/// invariants, so it is given in sigma. Infinite at det F <= 0. The Lame parameters of small strain are (mu,
/// lambda).
struct Hencky {
  static constexpr const char* name = "hencky";
  static constexpr double minimum_determinant = 0.0;

  double mu = 1.0;      ///< Shear modulus, in the units of psi.
  double lambda = 1.0;  ///< First Lame parameter, in the units of psi.

  template <class Visitor>
  void parameters(Visitor&& visit) {
    visit("mu", mu, "shear modulus");
    visit("lambda", lambda, "first Lame parameter");
  }

  template <class Require>
  void require_parameters(Require&& require) const {
    require("mu", mu >= 0, "must not be negative");
    require("lambda", lambda >= -2 * mu / 3, "must be at least -2/3 mu");
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const PrincipalStretches<Dim, T>& s) const {
    T sum(0.0), L(0.0);
    for (int i = 0; i < Dim; ++i) {
      const T l = log(s[i]);
      sum = fma(l, l, sum);
      L = L + l;
    }
    return mu * sum + 0.5 * lambda * L * L;
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE void derivatives(const PrincipalStretches<Dim, T>& s,
                                     StretchDerivatives<Dim, T>& d) const {
    T l[Dim], r[Dim];
    T sum(0.0), L(0.0);
    for (int i = 0; i < Dim; ++i) {
      l[i] = log(s[i]);
      r[i] = 1.0 / s[i];
      sum = fma(l[i], l[i], sum);
      L = L + l[i];
    }
    const T pressure = lambda * L;
    d.psi = mu * sum + 0.5 * pressure * L;
    for (int i = 0; i < Dim; ++i) {
      d.gradient[i] = (2.0 * mu * l[i] + pressure) * r[i];
      d.diagonal[i] = (2.0 * mu * (1.0 - l[i]) + lambda - pressure) * r[i] * r[i];
    }
    for (int i = 0; i < s.pairs; ++i) {
      const int j = first<Dim>(i), k = second<Dim>(i);
      const T pq = r[j] * r[k];
      // log(high) - log(low) over high - low, by log1p: 1/low times what tends to 1.
      const T low = min(s[j], s[k]), t = (max(s[j], s[k]) - low) / low;
      const T ratio = select(t == T(0.0), T(1.0), log1p(t) / select(t == T(0.0), T(1.0), t));
      d.twist[i] = (d.gradient[j] + d.gradient[k]) / s.safe_sum(i);
      d.flip[i] = (2.0 * mu * (ratio - min(l[j], l[k])) - pressure) * pq;
      d.coupling[i] = lambda * pq;
    }
  }
};

}  // namespace isostretch::energies
