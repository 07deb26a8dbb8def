#pragma once

#if defined(_OPENMP)
#include <omp.h>
#endif

namespace isostretch::cholesky {

// Threads of the next parallel loop, and which of them is at work. One without OpenMP.
inline int most_threads() {
#if defined(_OPENMP)
  return omp_get_max_threads();
#else
  return 1;
#endif
}

inline int this_thread() {
#if defined(_OPENMP)
  return omp_get_thread_num();
#else
  return 0;
#endif
}

}  // namespace isostretch::cholesky
