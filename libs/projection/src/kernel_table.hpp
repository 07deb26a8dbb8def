#pragma once

namespace isostretch::projection {

struct PointChunk;
struct FilterOptions;

// Stress and packed Hessians of a chunk whose derivatives are known; outputs have the chunk's stride and may
// be null.
struct ChunkOutputs {
  double* P;
  double* H;
  unsigned char* changed;  // per point: 1 where some eigenvalue was changed
};

struct ProjectionKernels {
  void (*decompose[2])(const PointChunk& chunk);
  void (*finish[2])(const PointChunk& chunk, const FilterOptions& filter, bool coupled,
                    const ChunkOutputs& out);
};

}  // namespace isostretch::projection
