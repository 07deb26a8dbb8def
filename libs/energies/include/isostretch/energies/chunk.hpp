#pragma once

#include <cstddef>

namespace isostretch::energies {

/// A few dozen quadrature points as an energy sees them, at their singular values. Structures of arrays,
/// entry e of point i at data[e * stride + i]. `count` is a multiple of 8, so kernels have no remainder;
/// whoever fills a chunk pads it with points at rest (sigma = 1). invariants::StretchDerivatives says what
/// the derivatives are.
struct StretchChunk {
  int count = 0;           ///< The number of points, padding included.
  std::size_t stride = 0;  ///< The distance between the entries e and e + 1 of a point, at least count.
  const double* sigma = nullptr;  ///< Signed singular values, dim entries.
  double* psi = nullptr;          ///< Energy densities, +infinity outside the domain of the energy.
  /// Derivatives; unused (may be null) when only psi is asked for.
  /// d psi / d sigma_i, dim entries; like all derivatives, not used and possibly null where only psi is asked
  /// for.
  double* gradient = nullptr;
  double* twist = nullptr;     ///< Twist eigenvalues, an entry per pair: 1 in 2D, 3 in 3D.
  double* flip = nullptr;      ///< Flip eigenvalues, an entry per pair.
  double* diagonal = nullptr;  ///< A_ii, dim entries.
  double* coupling = nullptr;  ///< A_jk of pair i, an entry per pair.
};

/// The kernels of one energy at one instruction-set level. Index 0 is dim 2, index 1 is dim 3; null where the
/// energy does not exist in that dimension.
struct EnergyFunctions {
  /// Compute chunk.psi from chunk.sigma.
  void (*psi[2])(const void* energy, const StretchChunk& chunk);
  /// Compute psi and all derivatives in the chunk from chunk.sigma.
  void (*derivatives[2])(const void* energy, const StretchChunk& chunk);
};

}  // namespace isostretch::energies
