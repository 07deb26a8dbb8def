#pragma once

namespace isostretch::app {

// Makes OpenMP threads that wait sleep instead of spin, unless the environment has its own opinion
// (OMP_WAIT_POLICY, GOMP_SPINCOUNT). Spinning is its default, and takes the core from the very thread that is
// waited for as soon as anything else runs on the machine: whole solves then took 2.5 times as long. OpenMP
// reads the variable before main(), so the program sets it and starts itself over; call this first in main().
void wait_asleep(const char* const* argv) noexcept;

// Threads of the parallel loops; 0 leaves what OpenMP chose (cores, OMP_NUM_THREADS). BLAS, where it is
// OpenBLAS, always gets one: how it splits a product changes the rounding, and results must not depend on the
// number of threads.
void set_threads(int count);
int thread_count();

}  // namespace isostretch::app
