#pragma once

#include <isostretch/energies/forms.hpp>

namespace isostretch::energies {

/// The energy of locally injective mappings (Schueller et al. 2013): psi = mu/2 |F|^2 + weight w(J) with the
/// C2 spline barrier w = 1/g - 1, g = xi^3 - 3 xi^2 + 3 xi, xi = (J - epsilon)/width on 0 < xi < 1, and w = 0
/// beyond. Infinite at det F <= epsilon.
struct LimBarrier {
  static constexpr const char* name = "lim_barrier";

  double mu = 1.0;        ///< Weight of the Dirichlet energy.
  double weight = 1.0;    ///< Weight of the barrier, in the units of psi.
  double epsilon = 1e-5;  ///< Determinant at which the barrier is infinite.
  double width = 1.0;     ///< Range of determinants over which the barrier acts.

  template <class Visitor>
  void parameters(Visitor&& visit) {
    visit("mu", mu, "weight of the Dirichlet energy");
    visit("weight", weight, "weight of the barrier");
    visit("epsilon", epsilon, "determinant at which the barrier is infinite");
    visit("width", width, "width over which the barrier acts");
  }

  template <class Require>
  void require_parameters(Require&& require) const {
    require("mu", mu >= 0, "must not be negative");
    require("weight", weight >= 0, "must not be negative");
    require("epsilon", epsilon >= 0, "must not be negative");
    require("width", width > 0, "must be positive");
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const Invariants<Dim, T>& I) const {
    const T xi = min((I.I3 - epsilon) / width, T(1.0));
    const T g = xi * (square(xi) - 3.0 * xi + 3.0);
    return 0.5 * mu * I.I2 + weight * (1.0 / g - 1.0);
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE T psi(const PrincipalStretches<Dim, T>& s) const {
    const T xi = min((s.J() - epsilon) / width, T(1.0));
    const T g = xi * (square(xi) - 3.0 * xi + 3.0);
    return 0.5 * mu * s.I2() + weight * (1.0 / g - 1.0);
  }

  template <int Dim, class T>
  ISOSTRETCH_INLINE void derivatives(const PrincipalStretches<Dim, T>& s,
                                     StretchDerivatives<Dim, T>& d) const {
    const T xi = min((s.J() - epsilon) / width, T(1.0));
    const T g = xi * (square(xi) - 3.0 * xi + 3.0), r = 1.0 / g, slack = xi - 1.0;
    const T g1 = 3.0 * slack * slack / width, g2 = 6.0 * slack / (width * width);
    set_zero(d);
    for (int i = 0; i < Dim; ++i) d.gradient[i] = mu * s[i], d.diagonal[i] = T(mu);
    for (int i = 0; i < s.pairs; ++i) d.twist[i] = d.flip[i] = T(mu);
    d.psi = 0.5 * mu * s.I2() + weight * (r - 1.0);
    add_volumetric(s, -weight * g1 * r * r, weight * (2.0 * square(g1 * r) - g2 * r) * r, d);
  }

  /// Returns epsilon, which det F must stay above.
  double determinant_bound() const { return epsilon; }
};

}  // namespace isostretch::energies
