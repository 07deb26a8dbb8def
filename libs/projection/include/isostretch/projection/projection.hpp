#pragma once

// Energy, stress and filtered Hessian at deformation gradients: the analytic eigensystem without a mesh
// around it.

#include <isostretch/core/pack.hpp>
#include <isostretch/energies/any_energy.hpp>
#include <isostretch/projection/filter.hpp>

#include <Eigen/Core>

#include <cstddef>

namespace isostretch::projection {

// Structures of arrays: entry e of point i at data[e * stride + i]. Matrices column by column (vec); H and K
// are upper triangles row by row (i <= j). Null outputs are skipped.
struct HessianBatch {
  const double* F = nullptr;
  double* psi = nullptr;
  double* P = nullptr;  // first Piola-Kirchhoff stress, d psi / d F
  double* H = nullptr;  // of the dim^2 x dim^2 Hessian over vec(F): 10 entries in 2D, 45 in 3D
  std::size_t count = 0;
  std::size_t stride = 0;
  // Instead of one stride, blocks of that many points (a multiple of 64): entry e of point i of an array of n
  // entries at data[(i / block * n + e) * block + i % block]. Large batches want it: 90 arrays a megabyte
  // apart exhaust the TLB.
  std::size_t block = 0;

  // Linear elements with one point each, nodes 0 ... dim: rest gradients of nodes 1 ... dim (node 0 has minus
  // their sum) and weights in; gradient and filtered Hessian of weight * psi over the element's (dim + 1) *
  // dim positions out, node by node. G or K need gradients and weights.
  const double* gradients = nullptr;  // dim * dim
  const double* weights = nullptr;    // 1
  double* G = nullptr;                // 6 entries in 2D, 12 in 3D
  double* K = nullptr;                // 21 entries in 2D, 78 in 3D
};

// Evaluates the batch on the calling thread and returns at how many points some eigenvalue was changed. Where
// the energy is infinite, derivatives are NaN. Throws Error when the energy does not exist in this dimension.
std::size_t evaluate(const energies::AnyEnergy& energy, int dim, const FilterOptions& filter,
                     const HessianBatch& batch);

inline namespace ISOSTRETCH_ISA {

template <int Dim>
struct PointHessian {
  double psi;
  Eigen::Matrix<double, Dim, Dim> P;
  Eigen::Matrix<double, Dim * Dim, Dim * Dim> H;
  bool filtered;  // whether some eigenvalue was changed
};

// One point: a batch of one.
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
