#pragma once

#include <cstddef>

namespace isostretch::projection {

struct PointChunk;
struct FilterOptions;

// Where the results of a chunk whose derivatives are known go, and rest gradients when element blocks are
// wanted; entry e of point i at data[e * stride + i]. Null outputs are skipped.
struct ChunkTask {
  std::size_t stride;
  double* P;                // stress
  double* H;                // packed Hessian over vec(F)
  double* G;                // element gradient
  double* K;                // packed element Hessian
  const double* gradients;  // (nodes - 1) * dim rest gradients, when G or K is given
  const double* weights;    // of the points, when G or K is given
  unsigned char* changed;   // per point: 1 where some eigenvalue was changed
};

struct ProjectionKernels {
  // F (f_stride apart) -> U, sigma, V of the chunk.
  void (*decompose[2])(const PointChunk& chunk, const double* F, std::size_t f_stride);
  void (*finish[2])(const PointChunk& chunk, const FilterOptions& filter, bool coupled,
                    const ChunkTask& task);
};

}  // namespace isostretch::projection
