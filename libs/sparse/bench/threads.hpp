#pragma once

#ifdef _OPENMP
#include <omp.h>
#endif

namespace isostretch::sparse::bench {

// Threads that regions of OpenMP have from now on. Those of BLAS are the environment's business.
inline void set_threads([[maybe_unused]] int threads) {
#ifdef _OPENMP
  omp_set_num_threads(threads);
#endif
}

// Threads that they would have.
inline int available_threads() {
#ifdef _OPENMP
  return omp_get_max_threads();
#else
  return 1;
#endif
}

}  // namespace isostretch::sparse::bench
