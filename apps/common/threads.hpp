#pragma once

namespace isostretch::app {

// Threads of the parallel loops; 0 leaves what OpenMP chose (cores, OMP_NUM_THREADS). BLAS, where it is
// OpenBLAS, always gets one: how it splits a product changes the rounding, and results must not depend on the
// number of threads.
void set_threads(int count);
int thread_count();

}  // namespace isostretch::app
