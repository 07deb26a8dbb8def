#pragma once

// The eigensystem of the energy Hessian at one deformation gradient, in closed form: for looking at, not for
// speed. Smith, de Goes, Kim 2019, section 4.

#include <isostretch/core/pack.hpp>
#include <isostretch/energies/any_energy.hpp>
#include <isostretch/invariants/eigensystem.hpp>

#include <Eigen/Core>

namespace isostretch::projection {
inline namespace ISOSTRETCH_ISA {

/// The eigenvalues and eigenvectors of the energy Hessian over vec(F). The columns of `vectors` are vec'ed
/// matrices, unit and mutually orthogonal: first the twists, then the flips (pair i spans the plane of
/// first(i) and second(i), invariants/stretch.hpp), then dim scaling modes.
template <int Dim>
struct Eigensystem {
  Eigen::Matrix<double, Dim * Dim, 1> values;           ///< One per column of `vectors`, in its order.
  Eigen::Matrix<double, Dim * Dim, Dim * Dim> vectors;  ///< Eigenvectors in columns.
};

/// Returns the eigensystem of the energy Hessian at F, in closed form (Smith, de Goes, Kim 2019, section 4).
/// Throws Error where the energy does not exist in this dimension or is infinite at F.
template <int Dim>
Eigensystem<Dim> eigensystem(const energies::AnyEnergy& energy, const Eigen::Matrix<double, Dim, Dim>& F) {
  constexpr int pairs = invariants::pair_count<Dim>;
  const invariants::Modes<Dim> modes(F);
  const auto d = energies::derivatives_at(energy, modes.stretch());
  Eigensystem<Dim> result;
  for (int i = 0; i < pairs; ++i) {
    result.values[i] = d.twist[i];
    result.vectors.col(i) = modes.twist(i);
    result.values[pairs + i] = d.flip[i];
    result.vectors.col(pairs + i) = modes.flip(i);
  }
  Eigen::Matrix<double, Dim, Dim> A = Eigen::Matrix<double, Dim, Dim>::Zero();
  for (int i = 0; i < Dim; ++i) A(i, i) = d.diagonal[i];
  for (int i = 0; i < pairs; ++i)
    A(invariants::first<Dim>(i), invariants::second<Dim>(i)) =
        A(invariants::second<Dim>(i), invariants::first<Dim>(i)) = d.coupling[i];
  const auto scaling = linalg::symmetric_eigen<Dim>(A);
  for (int k = 0; k < Dim; ++k) {
    result.values[2 * pairs + k] = scaling.lambda[k];
    auto column = result.vectors.col(2 * pairs + k);
    column.setZero();
    for (int i = 0; i < Dim; ++i) column += scaling.Q(i, k) * modes.scaling(i);
  }
  return result;
}

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch::projection
