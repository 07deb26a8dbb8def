#pragma once

// Kernel templates: the steps of the pipeline over a PointChunk, one pack at a time.

#include <isostretch/core/pack_pair.hpp>
#include <isostretch/projection/blocks.hpp>
#include <isostretch/projection/eigenvalues.hpp>
#include <isostretch/projection/point_chunk.hpp>

namespace isostretch::projection {
inline namespace ISOSTRETCH_ISA {

/// Returns the matrices of points i, i + 1, ..., as many as T has lanes, from entries column by column.
template <int Dim, class T = Pack>
ISOSTRETCH_INLINE Mat<Dim, T> load_matrix(const double* data, std::size_t stride, int i) {
  Mat<Dim, T> M;
  for (int c = 0; c < Dim; ++c)
    for (int r = 0; r < Dim; ++r)
      M[r][c] = load<T>(data + static_cast<std::size_t>(r + Dim * c) * stride + i);
  return M;
}

/// Writes the matrices of points i, i + 1, ..., entries column by column.
template <int Dim, class T>
ISOSTRETCH_INLINE void store_matrix(double* data, std::size_t stride, int i, const Mat<Dim, T>& M) {
  for (int c = 0; c < Dim; ++c)
    for (int r = 0; r < Dim; ++r) store(data + static_cast<std::size_t>(r + Dim * c) * stride + i, M[r][c]);
}

/// Computes U, sigma, V of points i ... i + wide_lanes - 1 from their F. WithVectors = false leaves U and V
/// alone.
template <int Dim, bool WithVectors>
ISOSTRETCH_INLINE void decompose(const Mat<Dim, WidePack>& F, const PointChunk& chunk, int i) {
  linalg::Svd<Dim, WidePack> svd;
  linalg::signed_svd<Dim, WithVectors>(F, svd);
  for (int e = 0; e < Dim; ++e)
    store(chunk.sigma + static_cast<std::size_t>(e) * chunk.stride + i, svd.sigma[e]);
  if constexpr (WithVectors) {
    store_matrix<Dim>(chunk.U, chunk.stride, i, svd.U);
    store_matrix<Dim>(chunk.V, chunk.stride, i, svd.V);
  }
}

/// Returns the derivatives of points i, i + 1, ... of a chunk, as many as a pack has lanes.
template <int Dim>
ISOSTRETCH_INLINE invariants::StretchDerivatives<Dim, Pack> load_derivatives(const energies::StretchChunk& c,
                                                                             int i) {
  invariants::StretchDerivatives<Dim, Pack> d;
  const auto entry = [&](const double* data, int e) {
    return load<Pack>(data + static_cast<std::size_t>(e) * c.stride + i);
  };
  d.psi = entry(c.psi, 0);
  for (int e = 0; e < Dim; ++e) d.gradient[e] = entry(c.gradient, e), d.diagonal[e] = entry(c.diagonal, e);
  for (int e = 0; e < d.pairs; ++e) {
    d.twist[e] = entry(c.twist, e);
    d.flip[e] = entry(c.flip, e);
    d.coupling[e] = entry(c.coupling, e);
  }
  return d;
}

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch::projection
