#pragma once

#include <cstddef>

namespace isostretch::energies {

// A few dozen quadrature points as the energy sees them: structures of arrays, entry e of point i at
// data[e * stride + i]. `count` is a multiple of 8, so kernels have no remainder; whoever fills a chunk pads
// it with points at rest (sigma = 1). What the entries are: invariants/stretch.hpp.
struct StretchChunk {
  int count = 0;
  std::size_t stride = 0;
  const double* sigma = nullptr;  // dim
  double* psi = nullptr;          // 1; +infinity outside the domain of the energy
  // Derivatives; unused (may be null) when only psi is asked for.
  double* gradient = nullptr;  // dim
  double* twist = nullptr;     // pairs: 1 in 2D, 3 in 3D
  double* flip = nullptr;      // pairs
  double* diagonal = nullptr;  // dim
  double* coupling = nullptr;  // pairs
};

// One energy's kernels at one instruction-set level; index 0 is dim 2, index 1 is dim 3, null where the
// energy does not exist in that dimension.
struct EnergyFunctions {
  void (*psi[2])(const void* energy, const StretchChunk& chunk);
  void (*derivatives[2])(const void* energy, const StretchChunk& chunk);
};

}  // namespace isostretch::energies
