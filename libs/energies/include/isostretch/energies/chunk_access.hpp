#pragma once

// Kernel templates: a pack of points out of a StretchChunk, and what was found there back into it.

#include <isostretch/energies/chunk.hpp>
#include <isostretch/invariants/stretch.hpp>

namespace isostretch::energies {
inline namespace ISOSTRETCH_ISA {

/// Returns the stretches of points i, i + 1, ... of a chunk, as many as a pack has lanes.
template <int Dim>
ISOSTRETCH_INLINE invariants::PrincipalStretches<Dim, Pack> load_stretch(const StretchChunk& chunk, int i) {
  invariants::PrincipalStretches<Dim, Pack> s;
  for (int e = 0; e < Dim; ++e)
    s.sigma[e] = load<Pack>(chunk.sigma + static_cast<std::size_t>(e) * chunk.stride + i);
  return s;
}

/// Writes the derivatives of points i, i + 1, ... to the chunk, without psi, which each caller guards by its
/// own domain.
template <int Dim>
ISOSTRETCH_INLINE void store_derivatives(const StretchChunk& chunk, int i,
                                         const invariants::StretchDerivatives<Dim, Pack>& d) {
  const auto put = [&](double* data, int entry, Pack value) {
    store(data + static_cast<std::size_t>(entry) * chunk.stride + i, value);
  };
  for (int e = 0; e < Dim; ++e) {
    put(chunk.gradient, e, d.gradient[e]);
    put(chunk.diagonal, e, d.diagonal[e]);
  }
  for (int e = 0; e < d.pairs; ++e) {
    put(chunk.twist, e, d.twist[e]);
    put(chunk.flip, e, d.flip[e]);
    put(chunk.coupling, e, d.coupling[e]);
  }
}

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch::energies
