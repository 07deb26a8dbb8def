#pragma once

#include <isostretch/energies/chunk.hpp>

#include <cstddef>

namespace isostretch::projection {

// Points per chunk: enough to amortise the indirect call, few enough for the arrays to stay in the
// first-level cache.
inline constexpr int chunk_size_2d = 64;
inline constexpr int chunk_size_3d = 32;
inline constexpr int chunk_size(int dim) {
  return dim == 2 ? chunk_size_2d : chunk_size_3d;
}

// Counts are multiples of this: the widest kernel takes two AVX-512 packs at a time.
inline constexpr int chunk_granularity = 16;
inline constexpr int padded_count(int points) {
  return (points + chunk_granularity - 1) / chunk_granularity * chunk_granularity;
}

// A chunk on its way through the pipeline: F -> U, sigma, V -> psi and its derivatives -> stress and Hessian
// blocks. Structures of arrays, entry e of point i at data[e * stride + i], matrices column by column.
struct PointChunk {
  int count = 0;  // padded_count() of the real points; padding points hold any deformation that is valid
  std::size_t stride = 0;
  double* F = nullptr;  // dim * dim
  double* U = nullptr;  // dim * dim
  double* V = nullptr;  // dim * dim
  double* sigma = nullptr;
  energies::StretchChunk stretch;  // its sigma is the one above
};

// Doubles that bind() needs.
inline constexpr std::size_t point_chunk_doubles(int dim) {
  const int pairs = dim == 2 ? 1 : 3;
  return static_cast<std::size_t>(chunk_size(dim)) *
         static_cast<std::size_t>(3 * dim * dim + dim + 1 + 2 * dim + 3 * pairs);
}

// Lays a chunk out over memory of that many doubles.
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
