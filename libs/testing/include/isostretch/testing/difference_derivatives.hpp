#pragma once

// For energies that exist only as psi(sigma): fourth-order central differences of psi over the entries of F,
// in long double (about 1e-9 relative, 1e-11 in the gradient).

#include <isostretch/invariants/stretch.hpp>
#include <isostretch/testing/automatic_derivatives.hpp>

#include <Eigen/Dense>

namespace isostretch::testing {
namespace detail {

template <int Dim>
using WideMatrix = Eigen::Matrix<long double, Dim, Dim>;

template <int Dim, class Energy>
long double wide_psi(const Energy& energy, const WideMatrix<Dim>& F) {
  using Value = AutomaticScalar<long double, 0>;
  const Eigen::JacobiSVD<WideMatrix<Dim>> svd(F);
  invariants::PrincipalStretches<Dim, Value> s;
  for (int i = 0; i < Dim; ++i) s.sigma[i] = Value(static_cast<long double>(svd.singularValues()[i]));
  if (F.determinant() < 0) s.sigma[Dim - 1] = -s.sigma[Dim - 1];
  return energy.psi(s).value;
}

inline constexpr int stencil_size = 4;
inline constexpr int stencil_offset[stencil_size] = {-2, -1, 1, 2};
inline constexpr long double stencil_weight[stencil_size] = {1.0L / 12, -8.0L / 12, 8.0L / 12, -1.0L / 12};

/// Returns d values(t) / dt at 0, from values at multiples of the step h.
template <class Values>
long double stencil(Values values, long double h) {
  long double sum = 0;
  for (int i = 0; i < stencil_size; ++i) sum += stencil_weight[i] * values(stencil_offset[i] * h);
  return sum / h;
}

}  // namespace detail

/// Returns psi, gradient and Hessian over vec(F) by fourth-order central differences of psi over the entries
/// of F, in long double (about 1e-9 relative, 1e-11 in the gradient), for energies that exist only as
/// psi(sigma).
template <int Dim, class Energy>
EntryDerivatives<Dim> difference_derivatives(const Energy& energy, const Eigen::Matrix<double, Dim, Dim>& F) {
  using detail::stencil;
  const detail::WideMatrix<Dim> wide = F.template cast<long double>();
  // Far below the smallest stretch, on which a barrier's derivatives depend; above the rounding of h^2.
  const long double smallest = Eigen::JacobiSVD<detail::WideMatrix<Dim>>(wide).singularValues()[Dim - 1];
  const long double h = 1e-3L * (smallest > 0 ? smallest : wide.norm());
  const auto moved = [&](int i, long double a, int j, long double b) {
    detail::WideMatrix<Dim> G = wide;
    G.data()[i] += a;
    G.data()[j] += b;
    return detail::wide_psi<Dim>(energy, G);
  };
  EntryDerivatives<Dim> d;
  d.psi = static_cast<double>(detail::wide_psi<Dim>(energy, wide));
  for (int i = 0; i < Dim * Dim; ++i) {
    d.gradient[i] = static_cast<double>(stencil([&](long double a) { return moved(i, a, i, 0); }, h));
    for (int j = 0; j <= i; ++j) {
      const auto slope = [&](long double a) {
        return stencil([&](long double b) { return moved(i, a, j, b); }, h);
      };
      d.hessian(i, j) = d.hessian(j, i) = static_cast<double>(stencil(slope, h));
    }
  }
  return d;
}

}  // namespace isostretch::testing
