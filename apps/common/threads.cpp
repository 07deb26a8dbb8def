#include "common/threads.hpp"

#include <dlfcn.h>
#ifdef _OPENMP
#include <omp.h>
#endif

namespace isostretch::app {

void set_threads([[maybe_unused]] int count) {
#ifdef _OPENMP
  if (count > 0) omp_set_num_threads(count);
#endif
  // Looked up at run time: any BLAS can stand behind libblas, and only this one has the function.
  using SetThreads = void (*)(int);
  if (void* symbol = ::dlsym(RTLD_DEFAULT, "openblas_set_num_threads"))
    reinterpret_cast<SetThreads>(symbol)(1);
}

int thread_count() {
#ifdef _OPENMP
  return omp_get_max_threads();
#else
  return 1;
#endif
}

}  // namespace isostretch::app
