#pragma once

#include <cstddef>

namespace isostretch::linalg {

struct SvdBatch;
struct PolarBatch;
struct EigenBatch;

// What decomposition_kernels.cpp offers at each instruction-set level, for dim 2 and 3, and for eigen
// 4 and 6 as well.
struct DecompositionKernels {
  void (*svd[2])(const SvdBatch&);
  void (*polar[2])(const PolarBatch&);
  void (*eigen[4])(const EigenBatch&);
};

}  // namespace isostretch::linalg
