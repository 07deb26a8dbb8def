#pragma once

#if defined(_OPENMP)
#include <omp.h>
#endif

namespace isostretch::cholesky::test {

// Sets the threads of parallel loops; 0: those there were at first.
inline void set_threads([[maybe_unused]] int count) {
#if defined(_OPENMP)
  static const int at_first = omp_get_max_threads();
  omp_set_num_threads(count > 0 ? count : at_first);
#endif
}

}  // namespace isostretch::cholesky::test
