#pragma once

#include <isostretch/energies/chunk.hpp>

#include <cstddef>

namespace isostretch::projection {

/// The number of points in a chunk of the plane: enough to amortise the indirect call, few enough for the
/// arrays to stay in the first-level cache.
inline constexpr int chunk_size_2d = 64;
/// The number of points in a chunk of space: enough to amortise the indirect call, few enough for the arrays
/// to stay in the first-level cache.
inline constexpr int chunk_size_3d = 32;
/// Returns the number of points in a chunk in dimension 2 or 3.
inline constexpr int chunk_size(int dim) {
  return dim == 2 ? chunk_size_2d : chunk_size_3d;
}

/// The number that counts of points are padded to multiples of: the widest kernel takes two AVX-512 packs at
/// a time.
inline constexpr int chunk_granularity = 16;
/// Returns the count of points, padded to a multiple of chunk_granularity.
inline constexpr int padded_count(int points) {
  return (points + chunk_granularity - 1) / chunk_granularity * chunk_granularity;
}

/// A chunk of quadrature points on its way through the pipeline: F -> U, sigma, V -> psi and its derivatives
/// -> stress and Hessian blocks. Structures of arrays with entry e of point i at data[e * stride + i],
/// matrices column by column.
struct PointChunk {
  int count = 0;            ///< padded_count() of the real points; padding points hold any valid deformation.
  std::size_t stride = 0;   ///< The distance between the entries e and e + 1 of a point, at least count.
  double* F = nullptr;      ///< Deformation gradients, dim * dim entries.
  double* U = nullptr;      ///< Rotations, dim * dim entries.
  double* V = nullptr;      ///< Rotations, dim * dim entries.
  double* sigma = nullptr;  ///< Signed singular values, dim entries.
  energies::StretchChunk stretch;  ///< psi and its derivatives; its sigma is that of the chunk.
};

/// Returns the number of doubles that bind_point_chunk() needs.
inline constexpr std::size_t point_chunk_doubles(int dim) {
  const int pairs = dim == 2 ? 1 : 3;
  return static_cast<std::size_t>(chunk_size(dim)) *
         static_cast<std::size_t>(3 * dim * dim + dim + 1 + 2 * dim + 3 * pairs);
}

/// Returns a chunk of chunk_size(dim) points laid out over memory of point_chunk_doubles(dim) doubles.
inline PointChunk bind_point_chunk(int dim, double* memory) {
  const int pairs = dim == 2 ? 1 : 3;
  PointChunk c;
  c.stride = static_cast<std::size_t>(chunk_size(dim));
  const auto take = [&](int entries) {
    double* block = memory;
    memory += static_cast<std::size_t>(entries) * c.stride;
    return block;
  };
  c.F = take(dim * dim);
  c.U = take(dim * dim);
  c.V = take(dim * dim);
  c.sigma = take(dim);
  c.stretch.stride = c.stride;
  c.stretch.sigma = c.sigma;
  c.stretch.psi = take(1);
  c.stretch.gradient = take(dim);
  c.stretch.diagonal = take(dim);
  c.stretch.twist = take(pairs);
  c.stretch.flip = take(pairs);
  c.stretch.coupling = take(pairs);
  return c;
}

}  // namespace isostretch::projection
