#include "serial_openmp.hpp"

#include <dlfcn.h>

namespace isostretch::sparse {
namespace {

// The runtime that CHOLMOD was linked with is found by name at run time: this library is built without OpenMP
// where the compiler has none, and CHOLMOD may still have one.
struct Runtime {
  using Get = int (*)();
  using Set = void (*)(int);
  Get get_max_active_levels = reinterpret_cast<Get>(::dlsym(RTLD_DEFAULT, "omp_get_max_active_levels"));
  Set set_max_active_levels = reinterpret_cast<Set>(::dlsym(RTLD_DEFAULT, "omp_set_max_active_levels"));
  bool found() const { return get_max_active_levels != nullptr && set_max_active_levels != nullptr; }
};

const Runtime& runtime() {
  static const Runtime instance;
  return instance;
}

}  // namespace

SerialOpenMP::SerialOpenMP() {
  if (!runtime().found()) return;
  previous_levels_ = runtime().get_max_active_levels();
  runtime().set_max_active_levels(0);
}

SerialOpenMP::~SerialOpenMP() {
  if (runtime().found()) runtime().set_max_active_levels(previous_levels_);
}

}  // namespace isostretch::sparse
