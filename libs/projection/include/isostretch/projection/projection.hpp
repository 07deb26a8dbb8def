#pragma once

// Energy, stress and filtered Hessian at deformation gradients: the analytic eigensystem without a mesh
// around it.

#include <isostretch/core/pack.hpp>
#include <isostretch/energies/any_energy.hpp>
#include <isostretch/projection/filter.hpp>

#include <Eigen/Core>

#include <cstddef>

namespace isostretch::projection {

/// A batch of deformation gradients with their energies, stresses and filtered Hessians. Structures of arrays
/// with entry e of point i at data[e * stride + i]; matrices are vec'ed column by column, H and K are upper
/// triangles row by row (i <= j). Null outputs are skipped.
struct HessianBatch {
  const double* F = nullptr;  ///< Deformation gradients, dim * dim entries.
  double* psi = nullptr;      ///< Energy densities.
  double* P = nullptr;        ///< First Piola-Kirchhoff stresses d psi / d F, dim * dim entries.
  double* H = nullptr;        ///< Hessians over vec(F), dim^2 x dim^2: 10 entries in 2D, 45 in 3D.
  std::size_t count = 0;      ///< The number of points.
  std::size_t stride = 0;     ///< The distance between the entries e and e + 1 of a point, at least count.
  /// The number of points in a block, a multiple of 64, or 0 for one stride. With blocks, entry e of point i
  /// of an array of n entries is at data[(i / block * n + e) * block + i % block]: large batches want it,
  /// because 90 arrays a megabyte apart exhaust the TLB.
  std::size_t block = 0;

  /// Rest gradients of nodes 1 ... dim, dim * dim entries; that of node 0 is minus their sum. Each point is
  /// taken as a linear element with nodes 0 ... dim; G and K need gradients and weights.
  const double* gradients = nullptr;
  const double* weights = nullptr;  ///< Rest areas or volumes, one entry per point.
  /// Gradients of weight * psi over positions, node by node: 6 entries in 2D, 12 in 3D.
  double* G = nullptr;
  /// Filtered Hessians of weight * psi over positions, (dim + 1) dim rows and columns: 21 entries in 2D, 78
  /// in 3D.
  double* K = nullptr;
};

/// Evaluates the batch on the calling thread and returns the number of points at which some eigenvalue was
/// changed. Where the energy is infinite, derivatives are NaN. Throws Error when the energy does not exist in
/// this dimension.
std::size_t evaluate(const energies::AnyEnergy& energy, int dim, const FilterOptions& filter,
                     const HessianBatch& batch);

inline namespace ISOSTRETCH_ISA {

/// The energy density, stress and filtered Hessian at one point.
template <int Dim>
struct PointHessian {
  double psi;                                     ///< Energy density.
  Eigen::Matrix<double, Dim, Dim> P;              ///< First Piola-Kirchhoff stress d psi / d F.
  Eigen::Matrix<double, Dim * Dim, Dim * Dim> H;  ///< Hessian over vec(F).
  bool filtered;                                  ///< Whether some eigenvalue was changed.
};

/// Returns psi, stress and filtered Hessian at one F, those of a batch of one.
template <int Dim>
PointHessian<Dim> evaluate(const energies::AnyEnergy& energy, const Eigen::Matrix<double, Dim, Dim>& F,
                           const FilterOptions& filter = {}) {
  PointHessian<Dim> result;
  double packed[Dim * Dim * (Dim * Dim + 1) / 2];
  result.filtered =
      evaluate(energy, Dim, filter, HessianBatch{F.data(), &result.psi, result.P.data(), packed, 1, 1}) > 0;
  const double* entry = packed;
  for (int i = 0; i < Dim * Dim; ++i)
    for (int j = i; j < Dim * Dim; ++j) result.H(i, j) = result.H(j, i) = *entry++;
  return result;
}

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch::projection
