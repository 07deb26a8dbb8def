#pragma once

#include <cstddef>

namespace isostretch::linalg {

struct SvdBatch;
struct PolarBatch;
struct EigenBatch;

// What decomposition_kernels.cpp offers at each instruction-set level; index 0 is dim 2, index 1 is dim 3.
struct DecompositionKernels {
  void (*svd[2])(const SvdBatch&);
  void (*polar[2])(const PolarBatch&);
  void (*eigen[2])(const EigenBatch&);
};

}  // namespace isostretch::linalg
