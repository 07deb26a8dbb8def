#include "common/threads.hpp"

#include <cstdlib>

#include <dlfcn.h>
#include <unistd.h>
#ifdef _OPENMP
#include <omp.h>
#endif

namespace isostretch::app {

void wait_asleep([[maybe_unused]] const char* const* argv) noexcept {
#ifdef _OPENMP
  if (std::getenv("OMP_WAIT_POLICY") != nullptr || std::getenv("GOMP_SPINCOUNT") != nullptr) return;
  if (::setenv("OMP_WAIT_POLICY", "passive", 0) != 0) return;
  ::execv("/proc/self/exe", const_cast<char* const*>(argv));  // where that fails, waiting is merely slower
#endif
}

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
